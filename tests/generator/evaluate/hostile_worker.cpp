// A worker that was taken over: what it tries is in the course's models/deed.txt. What it could do,
// or could not, it says as the failure of its answer.
//
//   hostile_worker --work ROOT ASSETS
#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using nlohmann::json;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

json next_question() {
  std::uint64_t size = 0;
  if (read(STDIN_FILENO, &size, sizeof size) != sizeof size) std::exit(0);
  std::string bytes(size, '\0');
  for (std::size_t at = 0; at < size;) {
    const ssize_t count = read(STDIN_FILENO, bytes.data() + at, size - at);
    if (count <= 0) std::exit(0);
    at += static_cast<std::size_t>(count);
  }
  return json::from_cbor(bytes);
}

void say(const std::string& bytes) {
  const std::uint64_t size = bytes.size();
  std::cout.write(reinterpret_cast<const char*>(&size), sizeof size) << bytes << std::flush;
}

json failure(const std::string& text) {
  return {{"whole", false},
          {"finding",
           {{"results", json::array()},
            {"seconds", json::array()},
            {"model_page", json::array()},
            {"diagnostics", json::array()}}},
          {"looked_at", json::array()},
          {"traced", true},
          {"failure", text},
          {"bytes", json::object()}};
}

std::string yes(bool done) {
  return done ? "yes" : "no";
}

// What it can reach, a line each.
std::string reach(const std::string& root, const std::string& secret) {
  const int network = socket(AF_INET, SOCK_STREAM, 0);
  std::string said = "reads a model: " + yes(!text_of(root + "/models/deed.txt").empty());
  said += ", reads a secret: " + yes(!text_of(secret).empty());
  said += ", reads the repository: " + yes(!text_of(root + "/.git/config").empty());
  said += ", writes a lesson: " +
          yes(open((root + "/content/x.md").c_str(), O_WRONLY | O_CREAT, 0600) >= 0);
  said +=
      ", has a secret in its environment: " + yes(std::getenv("MJCOURSE_TEST_SECRET") != nullptr);
  said += ", connects: " + yes(network >= 0);
  said += ", signals the generator: " + yes(kill(getppid(), 0) == 0);
  return said;
}

}  // namespace

int main(int, char** argv) {
  const std::string root = argv[2];
  const std::string deed = text_of(root + "/models/deed.txt");
  const std::string verb = deed.substr(0, deed.find(' '));
  const std::string object = deed.find(' ') == deed.npos ? "" : deed.substr(deed.find(' ') + 1);
  for (;;) {
    const json question = next_question();
    if (verb == "reach")
      say([&] {
        const std::vector<std::uint8_t> bytes = json::to_cbor(failure(reach(root, object)));
        return std::string(bytes.begin(), bytes.end());
      }());
    if (verb == "crash") {
      std::signal(SIGSEGV, SIG_DFL);  // a sanitizer has it otherwise
      std::raise(SIGSEGV);
    }
    if (verb == "leave") {
      std::cerr << "it had enough\n";
      return 3;
    }
    if (verb == "grow") {
      std::vector<std::string> all;
      for (;;) all.emplace_back(64 << 20, 'x');
    }
    if (verb == "babble") say("this is no answer");
    if (verb == "nest") say(std::string(1'000'000, '\x81'));  // CBOR: a list of one, of one, ...
    if (verb == "promise") {
      const std::uint64_t size = UINT64_MAX;
      std::cout.write(reinterpret_cast<const char*>(&size), sizeof size) << std::flush;
      for (;;) std::cout << std::string(1 << 20, 'x') << std::flush;
    }
    if (verb == "say") {
      const std::vector<std::uint8_t> bytes = json::to_cbor([&] {
        json answer = failure("");
        answer.merge_patch(json::parse(object));
        return answer;
      }());
      say(std::string(bytes.begin(), bytes.end()));
    }
  }
}
