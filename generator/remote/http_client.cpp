#include "remote/http_client.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "base/utf8.h"
#include "process/launch_news.h"
#include "remote/net_command.h"
#include "remote/passed_descriptor.h"

namespace mjcourse {
namespace {

constexpr time_t kPatience = 3;  // s, until a socket of this machine's takes a connection
// Twice as long as the program itself waits for a server.
constexpr std::chrono::seconds kMostWait{120};
constexpr std::size_t kMostSaid = 1 << 12;  // bytes of what the program says at its end

// The number in front of `text`, and what follows it.
std::pair<std::uint64_t, std::string_view> take_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return {number, text.substr(static_cast<std::size_t>(end - text.data()))};
}

// Each a message, since what a file holds has many lines.
std::string settings_of(const Server& server) {
  const StoreAddress& address = server.address;
  std::string settings;
  for (const auto& [name, value] :
       {std::pair("url", &address.url), std::pair("socket", &address.socket),
        std::pair("user", &address.user), std::pair("password", &address.password),
        std::pair("token", &server.token), std::pair("certificate", &server.certificate),
        std::pair("key", &server.key), std::pair("authorities", &server.authorities)}) {
    settings += frame_of(name, *value);
  }
  return settings;
}

// A connection to the socket at `path`; not open where there is none, with errno.
Descriptor connected(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  errno = ENAMETOOLONG;
  if (path.size() >= sizeof address.sun_path) return Descriptor();
  path.copy(address.sun_path, path.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  timeval patience{kPatience, 0};
  setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  const auto* const any = reinterpret_cast<const sockaddr*>(&address);
  if (::connect(socket.get(), any, sizeof address) != 0) socket.reset();
  return socket;
}

// Until it is the program, or could not become it.
void wait_for_start(const ChildProcess& child, const std::filesystem::path& program) {
  for (;;) {
    const LaunchNews news = read_launch_news(child.news.get());
    errno = news.failure;
    if (news.failure != 0) throw_errno(program);
    if (news.begun) return;
  }
}

}  // namespace

std::string HttpAnswer::trouble() const {
  if (status != 0) return "it answers with " + std::to_string(status);
  return readable(content.substr(0, content.find('\n')));
}

HttpClient::HttpClient(const std::filesystem::path& program, const Server& server)
    : server_(server), command_(net_command(program, server.address)), program_(command_) {
  wait_for_start(program_, program);
  send(frame_of("settings", settings_of(server)));
  reader_ = std::jthread([this] { read_answers(); });
}

HttpClient::~HttpClient() {
  program_.end();  // at which the reader ends
}

bool HttpClient::send(std::string_view bytes, const Descriptor& passed) {
  const std::lock_guard lock(sending_);
  const Descriptor none;
  for (const Descriptor* one = &passed; !bytes.empty();) {
    const ssize_t count = send_with(program_.in.get(), bytes, *one);
    if (count < 0 && errno != EINTR) return false;
    if (count <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    one = &none;
  }
  return true;
}

void HttpClient::read_answers() {
  FrameReader frames;
  std::string said;
  std::array<char, 1 << 16> buffer;
  // A stream that has ended is -1, which poll passes over.
  std::array<pollfd, 2> open{{{program_.out.get(), POLLIN, 0}, {program_.err.get(), POLLIN, 0}}};
  while (open[0].fd >= 0) {
    if (poll(open.data(), open.size(), -1) < 0) continue;
    for (pollfd& one : open) {
      if (one.revents == 0) continue;
      const ssize_t count = read(one.fd, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) one.fd = -1;
      if (count <= 0) continue;
      const std::string_view bytes(buffer.data(), static_cast<std::size_t>(count));
      if (&one == &open[0]) frames.add(bytes);
      if (&one == &open[1] && said.size() < kMostSaid) said += bytes;
    }
    try {
      while (auto message = frames.next()) take(*std::move(message));
    } catch (const std::length_error&) {
      break;  // it is not ours any more
    }
  }
  end(said);
}

void HttpClient::end(const std::string& said) {
  const std::lock_guard lock(mutex_);
  ended_ = "the program that talks to the server has ended" + (said.empty() ? "" : ": " + said);
  changed_.notify_all();
}

void HttpClient::take(Message message) {
  const auto [number, rest] = take_number(message.head);
  if (message.head == kConnectHead) return connect();
  const auto [status, behind] = take_number(rest.empty() ? rest : rest.substr(1));
  const std::uint64_t version = behind.empty() ? 0 : take_number(behind.substr(1)).first;
  const std::lock_guard lock(mutex_);
  if (const auto asked = asked_.find(number); asked != asked_.end()) {
    asked->second =
        HttpAnswer{static_cast<int>(status), static_cast<int>(version), std::move(message.body)};
  }
  changed_.notify_all();
}

// To the one place where the server is.
void HttpClient::connect() {
  const std::string& path = server_.address.socket;
  const Descriptor connection = path.empty() ? Descriptor() : connected(path);
  send(frame_of(kConnectedHead, connection.is_open() ? "" : std::strerror(errno)), connection);
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
  send(frame_of(head, content));  // where it cannot, it has ended
  std::unique_lock lock(mutex_);
  const auto asked = asked_.find(number);
  changed_.wait_for(lock, kMostWait, [&] { return !ended_.empty() || asked->second.has_value(); });
  HttpAnswer answer = asked->second.value_or(HttpAnswer{
      0, 0, ended_.empty() ? "the program that talks to the server gives no answer" : ended_});
  asked_.erase(asked);
  return answer;
}

}  // namespace mjcourse
