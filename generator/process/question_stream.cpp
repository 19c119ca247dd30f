#include "process/question_stream.h"

#include <unistd.h>

#include <cerrno>
#include <cstdint>

namespace mjcourse {
namespace {

// False at the end of the stream.
bool read_all(int descriptor, char* to, std::size_t size) {
  while (size > 0) {
    const ssize_t count = read(descriptor, to, size);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count < 0) continue;
    to += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool write_all(int descriptor, const char* from, std::size_t size) {
  while (size > 0) {
    const ssize_t count = write(descriptor, from, size);
    if (count < 0 && errno != EINTR) return false;
    if (count < 0) continue;
    from += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace

QuestionStream::QuestionStream() : answers_(dup(STDOUT_FILENO)) {
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

std::optional<std::string> QuestionStream::next() const {
  std::uint64_t size = 0;
  if (!read_all(STDIN_FILENO, reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
  std::string question(size, '\0');
  if (!read_all(STDIN_FILENO, question.data(), size)) return std::nullopt;
  return question;
}

bool QuestionStream::answer(std::string_view text) const {
  const std::uint64_t size = text.size();
  return write_all(answers_, reinterpret_cast<const char*>(&size), sizeof size) &&
         write_all(answers_, text.data(), text.size());
}

}  // namespace mjcourse
