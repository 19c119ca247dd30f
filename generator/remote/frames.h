// Messages between the generator and `mjcourse-net`, the program that talks to a server for it.
//
// Each is bytes behind their number, as 8 bytes in this machine's order. The first word of a
// question is its number, which its answer has, too; answers come in any order.
//
//     to the program   settings          and each as a message in the bytes behind a line feed
//                      17 PUT ac/3f2a…   and the bytes behind a line feed
//     back             17 200 2          by HTTP/2; and the bytes behind a line feed
//                      17 0              and why there was no answer
//
// Where the server is a socket of this machine, which the program cannot reach by itself, it is
// given its connections:
//
//     back             connect
//     to the program   connected         with a descriptor, or why there is none
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

inline constexpr const char *kConnectHead = "connect", *kConnectedHead = "connected";

// As it is sent.
std::string frame_of(std::string_view head, std::string_view body);

struct Message {
  std::string head, body;
};

// Takes messages out of bytes that come in pieces.
class FrameReader {
 public:
  void add(std::string_view bytes) { waiting_ += bytes; }
  // Throws std::length_error where one is larger than any may be.
  std::optional<Message> next();

 private:
  std::string waiting_;
  std::size_t begin_ = 0;  // of what was not taken yet
};

}  // namespace mjcourse
