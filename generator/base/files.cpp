#include "base/files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

namespace mjcourse {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPiece = 1 << 16;

}  // namespace

tl::expected<std::string, std::string> DiskFiles::read(const std::string& path) const {
  const fs::path full = root_ / path;
  std::error_code error;
  if (fs::is_directory(full, error)) return tl::unexpected(path + ": is a folder, not a file");
  // To open a pipe is to wait for whoever writes into it.
  if (fs::exists(full, error) && !fs::is_regular_file(full, error)) {
    return tl::unexpected(path + ": is not a file");
  }
  errno = 0;
  std::ifstream in(full, std::ios::binary);
  std::string bytes;
  // A file may say that it is smaller than it is, as those of the kernel do.
  const std::uintmax_t size = fs::file_size(full, error);
  for (std::size_t more = error ? 0 : size; in.good(); more = std::max(more, kPiece)) {
    const std::size_t known = bytes.size();
    bytes.resize(known + more + 1);  // one more byte finds the end
    in.read(bytes.data() + known, static_cast<std::streamsize>(more + 1));
    bytes.resize(known + static_cast<std::size_t>(in.gcount()));
  }
  if (!in.is_open() || in.bad()) {
    return tl::unexpected(path + ": " + std::generic_category().message(errno ? errno : EIO));
  }
  return bytes;
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
