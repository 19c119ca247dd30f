#include "remote/frames.h"

#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "base/store_entry.h"

namespace mjcourse {
namespace {

// An entry, and what it is packed in.
constexpr std::uint64_t kMostBytes = kMostEntryBytes + (std::size_t{1} << 20);

}  // namespace

std::string frame_of(std::string_view head, std::string_view body) {
  const std::uint64_t size = head.size() + 1 + body.size();
  std::string frame(sizeof size, '\0');
  std::memcpy(frame.data(), &size, sizeof size);
  frame.reserve(frame.size() + size);
  return frame.append(head).append("\n").append(body);
}

std::optional<Message> FrameReader::next() {
  std::uint64_t size = 0;
  const std::string_view rest = std::string_view(waiting_).substr(begin_);
  if (rest.size() < sizeof size) return std::nullopt;
  std::memcpy(&size, rest.data(), sizeof size);
  if (size > kMostBytes) throw std::length_error("a message is too large");
  if (rest.size() < sizeof size + size) return std::nullopt;
  const std::string_view all = rest.substr(sizeof size, size);
  const std::size_t end = std::min(all.find('\n'), all.size());
  Message message{std::string(all.substr(0, end)),
                  std::string(all.substr(std::min(end + 1, all.size())))};
  begin_ += sizeof size + size;
  if (begin_ == waiting_.size() || begin_ > (std::size_t{1} << 20)) {
    waiting_.erase(0, begin_);
    begin_ = 0;
  }
  return message;
}

}  // namespace mjcourse
