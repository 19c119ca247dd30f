#include "remote/http_client.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <utility>

#include "base/utf8.h"
#include "remote/frames.h"

namespace mjcourse {
namespace {

// The number in front of `text`, and what follows it.
std::pair<std::uint64_t, std::string_view> take_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return {number, text.substr(static_cast<std::size_t>(end - text.data()))};
}

std::string settings_of(const Server& server) {
  const StoreAddress& address = server.address;
  return "socket " + address.socket + "\nuser " + address.user + "\npassword " + address.password +
         "\ntoken " + server.token + "\ncertificate " + server.certificate + "\nkey " + server.key +
         "\nauthorities " + server.authorities + "\n";
}

// Its standard input and output are `socket`.
pid_t start(const std::filesystem::path& program, int socket) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  std::string name = program.string();
  char* arguments[] = {name.data(), nullptr};
  pid_t id = -1;
  const int error = posix_spawn(&id, name.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = error;
  if (error != 0) throw_errno(program);
  return id;
}

}  // namespace

std::string HttpAnswer::trouble() const {
  if (status != 0) return "it answers with " + std::to_string(status);
  return readable(content.substr(0, content.find('\n')));
}

HttpClient::HttpClient(const std::filesystem::path& program, const Server& server) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw_errno(program);
  socket_ = Descriptor(ends[0]);
  const Descriptor theirs(ends[1]);
  program_ = start(program, theirs.get());
  send(frame_of("url " + server.address.url, settings_of(server)));
  reader_ = std::jthread([this] { read_answers(); });
}

HttpClient::~HttpClient() {
  shutdown(socket_.get(), SHUT_RDWR);  // at which the program ends
  while (waitpid(program_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

bool HttpClient::send(std::string_view bytes) {
  const std::lock_guard lock(sending_);
  while (!bytes.empty()) {
    const ssize_t count = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void HttpClient::read_answers() {
  FrameReader frames;
  std::array<char, 1 << 16> buffer;
  for (;;) {
    const ssize_t count = recv(socket_.get(), buffer.data(), buffer.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    frames.add({buffer.data(), static_cast<std::size_t>(count)});
    while (auto message = frames.next()) {
      const auto [number, rest] = take_number(message->head);
      const auto [status, behind] = take_number(rest.empty() ? rest : rest.substr(1));
      const std::uint64_t version = behind.empty() ? 0 : take_number(behind.substr(1)).first;
      const std::lock_guard lock(mutex_);
      if (const auto asked = asked_.find(number); asked != asked_.end()) {
        asked->second = HttpAnswer{static_cast<int>(status), static_cast<int>(version),
                                   std::move(message->body)};
      }
      changed_.notify_all();
    }
  }
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

HttpAnswer HttpClient::ask(std::string_view verb, const std::string& path,
                           std::string_view content) {
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = ++last_;
    asked_[number];
  }
  const std::string head = std::to_string(number) + " " + std::string(verb) + " " + path;
  const bool sent = send(frame_of(head, content));
  std::unique_lock lock(mutex_);
  const auto asked = asked_.find(number);
  changed_.wait(lock, [&] { return !sent || ended_ || asked->second.has_value(); });
  HttpAnswer answer =
      asked->second.value_or(HttpAnswer{0, 0, "the program that talks to the server has ended"});
  asked_.erase(asked);
  return answer;
}

}  // namespace mjcourse
