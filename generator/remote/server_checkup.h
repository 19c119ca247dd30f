// What a server can do of all that a shared store needs, found out by trying.
// Tested by tests/store/remote.mjs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "remote/server.h"

namespace mjcourse {

struct ServerCheckup {
  std::string trouble;      // why it is of no use; empty where it is
  bool takes = false;       // what is put there, and has it then
  bool forbids = false;     // to put there
  std::string refusal;      // why it does not take it, or nothing larger
  bool tells = false;       // by HEAD, what it has
  std::size_t largest = 0;  // bytes, of what it took; it was given no more than kLargestTried
  int protocol = 0;         // the first number of HTTP's version
  double milliseconds = 0;  // until an answer, the median
};

inline constexpr std::size_t kLargestTried = std::size_t{32} << 20;

// `program` is mjcourse-net. With `puts`, a few entries are left there, always the same. Throws
// std::system_error where the program cannot be started.
ServerCheckup examine_server(const std::filesystem::path& program, const Server& server, bool puts);

}  // namespace mjcourse
