#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "base/descriptor.h"

namespace mjcourse {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPiece = 1 << 12;

}  // namespace

tl::expected<std::string, std::string> DiskFiles::read(const std::string& path) const {
  const fs::path full = root_ / path;
  const auto refused = [&](int reason) {
    return tl::unexpected(path + ": " + std::generic_category().message(reason));
  };
  struct stat status {};
  if (stat(full.c_str(), &status) != 0) return refused(errno);
  if (S_ISDIR(status.st_mode)) return tl::unexpected(path + ": is a folder, not a file");
  // To open a pipe is to wait for whoever writes into it.
  if (!S_ISREG(status.st_mode)) return tl::unexpected(path + ": is not a file");
  const Descriptor file(open(full.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) return refused(errno);
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t known = 0;
  // A file may be larger than it says, as those of the kernel are.
  std::array<char, kPiece> beyond{};
  while (true) {
    const bool told = known < bytes.size();
    const ssize_t count = told ? ::read(file.get(), bytes.data() + known, bytes.size() - known)
                               : ::read(file.get(), beyond.data(), beyond.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return refused(errno);
    if (!told) bytes.append(beyond.data(), static_cast<std::size_t>(count));
    known += static_cast<std::size_t>(count);
    if (count > 0) continue;
    bytes.resize(known);
    return bytes;
  }
}

bool DiskFiles::exists(const std::string& path) const {
  std::error_code error;
  return fs::is_regular_file(root_ / path, error);
}

std::vector<std::string> DiskFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(root_ / folder, error)) {
    if (entry.is_regular_file(error)) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

tl::expected<std::string, std::string> MemoryFiles::read(const std::string& path) const {
  const auto found = files_.find(path);
  if (found == files_.end()) return tl::unexpected(path + ": No such file or directory");
  return found->second;
}

bool MemoryFiles::exists(const std::string& path) const {
  return files_.contains(path);
}

std::vector<std::string> MemoryFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& [path, bytes] : files_) {
    if (!path.starts_with(folder + "/")) continue;
    const std::string name = path.substr(folder.size() + 1);
    if (name.find('/') == std::string::npos) names.push_back(name);
  }
  return names;
}

void write_file(const fs::path& path, std::string_view bytes) {
  fs::create_directories(fs::absolute(path).parent_path());
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::system_error(errno ? errno : EIO, std::generic_category(), path.string());
}

}  // namespace mjcourse
