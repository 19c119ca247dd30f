#include "base/files.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <limits>
#include <set>
#include <string_view>
#include <system_error>

#include "base/descriptor.h"

namespace mjcourse {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPiece = 1 << 12;

// Of what is read into memory. GitHub takes no file of 100 MB.
constexpr off_t kMostOfAFile = 256 << 20;
constexpr const char* kTooLarge = "is larger than 256 MiB";

tl::expected<std::string, std::string> bytes_of(const Descriptor& file, const struct stat& status,
                                                off_t most) {
  if (status.st_size > most) return tl::unexpected(std::string(kTooLarge));
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t known = 0;
  // A file may be larger than it says, as those of the kernel are.
  std::array<char, kPiece> beyond{};
  while (true) {
    const bool told = known < bytes.size();
    const ssize_t count = told ? ::read(file.get(), bytes.data() + known, bytes.size() - known)
                               : ::read(file.get(), beyond.data(), beyond.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return tl::unexpected(std::generic_category().message(errno));
    if (!told) bytes.append(beyond.data(), static_cast<std::size_t>(count));
    known += static_cast<std::size_t>(count);
    if (known > static_cast<std::size_t>(most)) return tl::unexpected(std::string(kTooLarge));
    if (count > 0) continue;
    bytes.resize(known);
    return bytes;
  }
}

struct Named {
  std::string name;
  unsigned char type;  // DT_DIR, …
};

// What is in `folder`, sorted; empty where it cannot be listed.
std::vector<Named> names_in(const Beneath& beneath, const std::string& folder) {
  std::vector<Named> names;
  tl::expected<Descriptor, Unopened> opened = beneath.folder(folder);
  if (!opened) return names;
  DIR* const entries = fdopendir(opened->get());
  if (entries == nullptr) return names;
  const int number = opened->release();
  while (const dirent* entry = readdir(entries)) {
    const std::string name = entry->d_name;
    if (name == "." || name == ".." || name == ".git") continue;
    unsigned char type = entry->d_type;
    struct stat status {};
    // Some file systems do not tell.
    if (type == DT_UNKNOWN && fstatat(number, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
      type = static_cast<unsigned char>(IFTODT(status.st_mode));
    }
    names.push_back({name, type});
  }
  closedir(entries);
  std::sort(names.begin(), names.end(),
            [](const Named& a, const Named& b) { return a.name < b.name; });
  return names;
}

}  // namespace

tl::expected<std::string, std::string> DiskFiles::read(const std::string& path) const {
  const auto because = [&](const std::string& why) { return tl::unexpected(path + ": " + why); };
  const tl::expected<Beneath::File, Unopened> file = beneath_.file(path);
  if (!file) return because(file.error().why);
  auto bytes = bytes_of(file->descriptor, file->status, kMostOfAFile);
  if (!bytes) return because(bytes.error());
  return *std::move(bytes);
}

bool DiskFiles::exists(const std::string& path) const {
  const auto status = beneath_.status(path);
  return status ? !S_ISDIR(status->st_mode) : status.error().is_refused();
}

bool DiskFiles::is_folder(const std::string& path) const {
  const auto status = beneath_.status(path);
  return status && S_ISDIR(status->st_mode);
}

std::optional<FileRefusal> DiskFiles::refusal(const std::string& path) const {
  const auto status = beneath_.status(path);
  if (!status) return status.error().refusal();
  if (S_ISDIR(status->st_mode)) return std::nullopt;
  if (!S_ISREG(status->st_mode)) return refusal_of_no_file();
  if (status->st_size <= kMostOfAFile) return std::nullopt;
  return FileRefusal{kTooLarge, "put a smaller one there"};
}

std::vector<std::string> DiskFiles::list(const std::string& folder) const {
  std::vector<std::string> names;
  for (const Named& one : names_in(beneath_, folder)) {
    const std::string path = folder.empty() ? one.name : folder + "/" + one.name;
    if (one.type == DT_REG || (one.type != DT_DIR && exists(path))) names.push_back(one.name);
  }
  return names;
}

std::vector<std::string> DiskFiles::folders(const std::string& folder) const {
  std::vector<std::string> names;
  for (const Named& one : names_in(beneath_, folder)) {
    const std::string path = folder.empty() ? one.name : folder + "/" + one.name;
    if (one.type == DT_DIR || (one.type == DT_LNK && is_folder(path))) names.push_back(one.name);
  }
  return names;
}

std::vector<std::string> DiskFiles::list_below(const std::string& folder) const {
  std::vector<std::string> names;
  for (const Entry& entry : below(folder)) {
    if (entry.is_folder || !exists(entry.path)) continue;
    names.push_back(entry.path.substr(folder.empty() ? 0 : folder.size() + 1));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<DiskFiles::Entry> DiskFiles::below(const std::string& folder) const {
  std::vector<Entry> entries;
  add_below(folder, entries);
  return entries;
}

void DiskFiles::add_below(const std::string& folder, std::vector<Entry>& entries) const {
  for (const Named& one : names_in(beneath_, folder)) {
    const std::string path = folder.empty() ? one.name : folder + "/" + one.name;
    const bool is_folder = one.type == DT_DIR && !is_too_deep(path);
    entries.push_back({path, is_folder});
    if (is_folder) add_below(path, entries);
  }
}

std::string read_again(const Files& files, const std::string& path) {
  auto bytes = files.read(path);
  if (!bytes) throw LostFile(bytes.error());
  return *std::move(bytes);
}

tl::expected<std::string, std::string> read_beneath(const fs::path& root, const fs::path& path) {
  const auto name = name_beneath(root, path);
  if (!name) return tl::unexpected(path.string() + ": " + name.error().why);
  return DiskFiles(root).read(*name);
}

tl::expected<std::string, std::string> read_file(const fs::path& path) {
  const auto because = [&](int reason) {
    return tl::unexpected(path.string() + ": " + std::generic_category().message(reason));
  };
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (!file.is_open() || fstat(file.get(), &status) != 0) return because(errno);
  if (S_ISDIR(status.st_mode)) return because(EISDIR);
  if (!S_ISREG(status.st_mode)) return tl::unexpected(path.string() + ": is not a file");
  auto bytes = bytes_of(file, status, std::numeric_limits<off_t>::max());
  if (!bytes) return tl::unexpected(path.string() + ": " + bytes.error());
  return *std::move(bytes);
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

std::vector<std::string> MemoryFiles::folders(const std::string& folder) const {
  std::set<std::string> names;
  for (const auto& [path, bytes] : files_) {
    if (!path.starts_with(folder + "/")) continue;
    const std::size_t end = path.find('/', folder.size() + 1);
    if (end != path.npos) names.insert(path.substr(folder.size() + 1, end - folder.size() - 1));
  }
  return {names.begin(), names.end()};
}

std::vector<std::string> MemoryFiles::list_below(const std::string& folder) const {
  std::vector<std::string> names;
  for (const auto& [path, bytes] : files_) {
    if (path.starts_with(folder + "/")) names.push_back(path.substr(folder.size() + 1));
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
