// mjcourse-net: sends requests to one server, many at once, and gives their answers.
//
// The generator starts it, confined (remote/net_command.h), asks by messages on its standard input,
// and reads answers from its standard output (remote/frames.h). It ends with its input.
// Tested by tests/store/remote.mjs.
#include <curl/curl.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <iostream>

#include "remote/client/input.h"
#include "remote/client/settled_calls.h"
#include "remote/client/transfers.h"
#include "remote/frames.h"

namespace mjcourse {
namespace {

bool write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void serve() {
  Input input(STDIN_FILENO);
  std::optional<Message> settings;
  while (!(settings = input.next())) {
    if (!input.read()) return;
  }
  Transfers transfers(settings->body, [&input] {
    return write_all(frame_of(kConnectHead, "")) ? input.connection() : Descriptor();
  });
  for (;;) {
    while (auto question = input.next()) transfers.begin(*std::move(question));
    const bool is_asked = transfers.wait(STDIN_FILENO);
    for (const std::string& answer : transfers.finished()) {
      if (!write_all(answer)) return;
    }
    if (is_asked && !input.read()) return;
  }
}

}  // namespace
}  // namespace mjcourse

int main() {
  try {
    mjcourse::settle_calls(mjcourse::kNoPrograms);
    curl_global_init(CURL_GLOBAL_ALL);
    mjcourse::serve();
  } catch (const std::exception& error) {
    std::cerr << "mjcourse-net: " << error.what() << '\n';
    return 1;
  }
}
