#include "remote/client/input.h"

#include <array>
#include <cerrno>
#include <utility>

#include "remote/passed_descriptor.h"

namespace mjcourse {

bool Input::read() {
  std::array<char, 1 << 16> buffer;
  Received received = receive_with(in_, buffer.data(), buffer.size());
  if (received.count < 0 && errno == EINTR) return true;
  if (received.count <= 0) return false;
  if (received.passed.is_open()) passed_.push_back(std::move(received.passed));
  frames_.add({buffer.data(), static_cast<std::size_t>(received.count)});
  while (auto message = frames_.next()) {
    if (message->head != kConnectedHead) {
      messages_.push_back(*std::move(message));
      continue;
    }
    // The descriptor came with the first byte of it; of one that says why there is none, none did.
    connections_.emplace_back();
    if (!message->body.empty() || passed_.empty()) continue;
    connections_.back() = std::move(passed_.front());
    passed_.pop_front();
  }
  return true;
}

std::optional<Message> Input::next() {
  if (messages_.empty()) return std::nullopt;
  Message message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

Descriptor Input::connection() {
  while (connections_.empty()) {
    if (!read()) return Descriptor();
  }
  Descriptor connection = std::move(connections_.front());
  connections_.pop_front();
  return connection;
}

}  // namespace mjcourse
