// A `mjcourse-net` that was taken over: to its first question it answers what it could reach. The
// question's bytes are what it tries, a line each: a verb, an object.
//
//   hostile_net
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/mman.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include "remote/client/settled_calls.h"
#include "remote/frames.h"

namespace mjcourse {
namespace {

Message next_message(FrameReader& frames) {
  for (;;) {
    if (auto message = frames.next()) return *std::move(message);
    char buffer[4096];
    const ssize_t count = read(STDIN_FILENO, buffer, sizeof buffer);
    if (count <= 0) std::exit(0);
    frames.add({buffer, static_cast<std::size_t>(count)});
  }
}

bool reads(const std::string& path) {
  std::ifstream file(path);
  return file.get() != std::ifstream::traits_type::eof();
}

bool lists(const std::string& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY) >= 0;
}

bool writes(const std::string& path) {
  return open(path.c_str(), O_WRONLY | O_CREAT, 0600) >= 0;
}

bool knows(const std::string& variable) {
  return std::getenv(variable.c_str()) != nullptr;
}

bool starts(const std::string& program) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  if (child > 0) return true;
  char* const arguments[] = {const_cast<char*>(program.c_str()), nullptr};
  // Where it does become one, no answer is given.
  execv(program.c_str(), arguments);
  return false;
}

bool signals(const std::string& process) {
  return kill(std::atoi(process.c_str()), 0) == 0;
}

bool traces(const std::string& process) {
  return ptrace(PTRACE_SEIZE, std::atoi(process.c_str()), nullptr, nullptr) == 0;
}

sockaddr_in place_of(const std::string& port) {
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(static_cast<std::uint16_t>(std::atoi(port.c_str())));
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return place;
}

bool connects(const std::string& port) {
  const sockaddr_in place = place_of(port);
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  return connect(connection, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
}

// With the first of its words, which is another way to connect.
bool sends_at_once(const std::string& port) {
  const sockaddr_in place = place_of(port);
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  return sendto(connection, "x", 1, MSG_FASTOPEN, reinterpret_cast<const sockaddr*>(&place),
                sizeof place) > 0;
}

bool serves(const std::string& port) {
  const sockaddr_in place = place_of(port);
  const int server = socket(AF_INET, SOCK_STREAM, 0);
  return bind(server, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0 ||
         listen(server, 1) == 0;
}

// "1 1": one of that family and kind.
bool opens_socket(const std::string& numbers) {
  int family = 0, kind = 0, protocol = 0;
  std::istringstream(numbers) >> family >> kind >> protocol;
  return socket(family, kind, protocol) >= 0;
}

bool takes_memory(const std::string& gibibytes) {
  const std::size_t size = static_cast<std::size_t>(std::atoi(gibibytes.c_str())) << 30;
  return mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
         MAP_FAILED;
}

bool is_root(const std::string&) {
  return getuid() == 0;
}

const std::map<std::string, std::function<bool(const std::string&)>> kDeeds{
    {"reads", reads},
    {"lists", lists},
    {"writes", writes},
    {"knows", knows},
    {"starts", starts},
    {"signals", signals},
    {"traces", traces},
    {"connects", connects},
    {"serves", serves},
    {"socket", opens_socket},
    {"takes", takes_memory},
    {"is-root", is_root},
    {"sends-at-once", sends_at_once}};

// Each line with what came of it.
std::string done(const std::string& deeds) {
  std::istringstream lines(deeds);
  std::string said;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = std::min(line.find(' '), line.size());
    const std::string object = space < line.size() ? line.substr(space + 1) : "";
    said += line + (kDeeds.at(line.substr(0, space))(object) ? ": yes\n" : ": no\n");
  }
  return said;
}

// What is no answer to a question: of another size, without a number, with another one's.
void say_before(const std::string& what) {
  const std::string text = what == "promises" ? std::string(8, '\xff') + "\n" : frame_of(what, "x");
  if (write(STDOUT_FILENO, text.data(), text.size()) < 0) std::exit(1);
}

void serve() {
  FrameReader frames;
  next_message(frames);  // its settings
  for (;;) {
    const Message question = next_message(frames);
    if (question.head == kConnectedHead) continue;
    const std::string number = question.head.substr(0, question.head.find(' '));
    if (question.body.starts_with("says ")) say_before(question.body.substr(5));
    if (question.body == "leaves") {
      std::cerr << "it had enough" << std::endl;
      std::exit(3);
    }
    const std::string said = question.body.starts_with("says ") ? "said" : done(question.body);
    const std::string answer = frame_of(number + " 200 1", said);
    if (write(STDOUT_FILENO, answer.data(), answer.size()) < 0) return;
  }
}

}  // namespace
}  // namespace mjcourse

int main() {
  mjcourse::settle_calls(mjcourse::kNoPrograms);  // as the real one does
  mjcourse::serve();
}
