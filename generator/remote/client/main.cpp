// mjcourse-net: sends requests to one server, many at once, and gives their answers.
//
// The generator starts it (remote/http_client.h), asks by messages on its standard input, and reads
// answers from its standard output (remote/frames.h). It ends with its input.
// Tested by tests/store/remote.mjs.
#include <curl/curl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <iostream>

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

// What can be read now; false at the end.
bool read_into(FrameReader& frames) {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(STDIN_FILENO, buffer.data(), buffer.size());
  if (count > 0) frames.add({buffer.data(), static_cast<std::size_t>(count)});
  return count > 0 || (count < 0 && errno == EINTR);
}

void serve() {
  FrameReader frames;
  std::optional<Message> settings;
  while (!(settings = frames.next())) {
    if (!read_into(frames)) return;
  }
  Transfers transfers(*settings);
  for (;;) {
    while (auto question = frames.next()) transfers.begin(*std::move(question));
    const bool is_asked = transfers.wait(STDIN_FILENO);
    for (const std::string& answer : transfers.finished()) {
      if (!write_all(answer)) return;
    }
    if (is_asked && !read_into(frames)) return;
  }
}

}  // namespace
}  // namespace mjcourse

int main() {
  try {
    curl_global_init(CURL_GLOBAL_ALL);
    mjcourse::serve();
  } catch (const std::exception& error) {
    std::cerr << "mjcourse-net: " << error.what() << '\n';
    return 1;
  }
}
