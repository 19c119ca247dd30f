// HttpClient: asks a server for us, by a program of its own, `mjcourse-net`.
//
// What a server sends is anybody's, and what reads it is a large library. So that runs elsewhere,
// confined (net_command.h), and what the generator is made of, which is in the keys of results,
// does not depend on it. The program has many requests under way at once; each caller waits for its
// own. Tested by tests/generator/remote/http_client_test.cpp.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "base/descriptor.h"
#include "process/child_process.h"
#include "process/subprocess.h"
#include "remote/frames.h"
#include "remote/server.h"

namespace mjcourse {

// Those that mean something to us.
enum HttpStatus : int {
  kOk = 200,
  kPartialContent = 206,
  kUnauthorized = 401,
  kForbidden = 403,
  kNotFound = 404,
  kMethodNotAllowed = 405,
  kGone = 410,
  kContentTooLarge = 413,
  kNotImplemented = 501,
  kInsufficientStorage = 507,
};

struct HttpAnswer {
  int status = 0;       // of HTTP; 0 where no whole answer came
  int version = 0;      // of HTTP, its first number
  std::string content;  // or why none came

  // "it answers with 500", or why no answer came.
  std::string trouble() const;
  bool is_good() const { return status >= kOk && status < kPartialContent; }
};

class HttpClient {
 public:
  // `program` is mjcourse-net. Throws std::system_error where it cannot be started.
  HttpClient(const std::filesystem::path& program, const Server& server);
  // Callers that still wait get no answer.
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  // `verb` is GET, HEAD or PUT; `path` is below the server's folder. From any thread; waits.
  HttpAnswer ask(std::string_view verb, const std::string& path, std::string_view content = {});

 private:
  bool send(std::string_view bytes, const Descriptor& passed = Descriptor());
  void read_answers();
  void take(Message message);
  void connect();
  void end(const std::string& said);

  const Server server_;
  const Command command_;
  ChildProcess program_;
  std::mutex sending_, mutex_;
  std::condition_variable changed_;
  std::map<std::uint64_t, std::optional<HttpAnswer>> asked_;  // by their numbers
  std::uint64_t last_ = 0;
  std::string ended_;    // why it answers no more
  std::jthread reader_;  // last: it uses the rest
};

}  // namespace mjcourse
