#include "base/spool.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "base/descriptor.h"

namespace mjcourse {

Spool::Spool()
    : file_(open(std::filesystem::temp_directory_path().c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC,
                 0600)) {
  if (file_ < 0) throw_errno("a temporary file");
}

Spool::~Spool() {
  close(file_);
}

Spool::Piece Spool::put(std::string_view text) {
  const Piece piece{end_.fetch_add(static_cast<std::int64_t>(text.size())), text.size()};
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = pwrite(file_, text.data() + done, text.size() - done,
                                 piece.begin + static_cast<std::int64_t>(done));
    if (count < 0 && errno != EINTR) throw_errno("a temporary file");
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return piece;
}

std::string Spool::get(Piece piece) const {
  std::string text(piece.size, '\0');
  for (std::size_t done = 0; done < piece.size;) {
    const ssize_t count = pread(file_, text.data() + done, piece.size - done,
                                piece.begin + static_cast<std::int64_t>(done));
    if (count < 0 && errno != EINTR) throw_errno("a temporary file");
    if (count == 0) throw std::logic_error("a piece behind the end of its spool");
    if (count > 0) done += static_cast<std::size_t>(count);
  }
  return text;
}

}  // namespace mjcourse
