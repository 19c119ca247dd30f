#include "base/disk_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>
#include <utility>

#include "base/descriptor.h"
#include "base/folder_size.h"
#include "base/store_entry.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// All that lies in a store: results, their bytes, what is being written, headers made beforehand,
// and two stamps.
constexpr std::array kParts{"ac", "cas", "tmp", "prepared", "lock", "pruned"};
constexpr std::time_t kHour = 3600;  // seconds

// The bytes of the file at `path`; nothing where there is none. What is no file of a store (a link,
// a device, what is too large) is damaged: empty. `status` is that of what was read.
std::optional<std::string> read_entry(const fs::path& path, struct stat& status) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0) return errno == ELOOP ? std::optional("") : std::nullopt;
  if (fstat(file.get(), &status) != 0) return std::nullopt;
  if (!S_ISREG(status.st_mode) || std::cmp_greater(status.st_size, kMostEntryBytes)) return "";
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t size = 0;
  while (size < bytes.size()) {
    const ssize_t count = read(file.get(), bytes.data() + size, bytes.size() - size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    size += static_cast<std::size_t>(count);
  }
  bytes.resize(size);
  return bytes;
}

// `file` is what lies at `path`.
void mark_used(const fs::path& path, const struct stat& file) {
  if (std::time(nullptr) - file.st_mtime >= kHour) utimensat(AT_FDCWD, path.c_str(), nullptr, 0);
}

// What a store removes is its own, so a folder with anything else in it is none.
void refuse_other_folder(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (std::ranges::count(kParts, name) > 0) continue;
    throw std::system_error(ENOTEMPTY, std::generic_category(),
                            folder.string() + " is not a store, as it holds " + name);
  }
}

int open_lock(const fs::path& folder) {
  return open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
}

}  // namespace

DiskStore::DiskStore(fs::path folder, Trust trust)
    : folder_(std::move(folder)), trust_(std::move(trust)) {
  try {
    prepare();
  } catch (const std::system_error& error) {
    const int reason = error.code().value();
    if ((reason != EACCES && reason != EROFS && reason != EPERM) || !fs::exists(folder_ / "ac")) {
      throw;
    }
    writable_ = false;
    note("the store is read and not written: " + std::string(error.what()));
    lock_ = Descriptor(
        open((folder_ / "lock").c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  }
  while (lock_.is_open() && flock(lock_.get(), LOCK_SH) != 0) {
    if (errno != EINTR) throw_errno(folder_ / "lock");
  }
  const fs::path prepared = prepared_folder(folder_);
  if (fs::exists(prepared) && !fs::is_directory(prepared)) {
    note(prepared.string() + " is not a folder, so headers are compiled in each run; remove it");
  }
}

// What it writes, and forgets, lies in itself: a link may lead anywhere.
void DiskStore::prepare() {
  refuse_other_folder(folder_);
  for (const char* kind : {"ac", "cas", "tmp", "prepared"}) {
    if (!fs::is_symlink(folder_ / kind)) continue;
    throw std::system_error(ENOTDIR, std::generic_category(), (folder_ / kind).string());
  }
  fs::create_directories(folder_ / "tmp");
  if (eaccess((folder_ / "tmp").c_str(), W_OK) != 0) throw_errno(folder_ / "tmp");
  lock_ = Descriptor(open_lock(folder_));
  if (!lock_.is_open()) throw_errno(folder_ / "lock");
}

fs::path DiskStore::path_of(const std::string& name) const {
  const std::size_t hash = name.find('/') + 1;
  // What is sealed says itself of which kind it is.
  const char* const kind = name.starts_with("cas/") ? "cas" : "ac";
  return folder_ / kind / name.substr(hash, 2) / name.substr(hash + 2);
}

std::optional<Stored> DiskStore::find(const std::string& name) {
  if (!is_store_name(name)) return std::nullopt;
  const fs::path path = path_of(name);
  if (fs::is_symlink(path.parent_path())) return std::nullopt;
  struct stat status {};
  std::optional<std::string> bytes = read_entry(path, status);
  if (!bytes || is_stored_by_another_version(*bytes)) return std::nullopt;
  std::optional<Stored> stored = unsealed_stored(name, *std::move(bytes));
  if (!stored) {
    note("the store's entry " + name + " was damaged; it is made again");
    std::error_code ignored;
    fs::remove_all(path, ignored);
  } else if (!trust_.believes(stored->origin)) {
    note_doubt(name);
    return std::nullopt;
  } else {
    mark_used(path, status);
  }
  return stored;
}

void DiskStore::note_doubt(const std::string& name) {
  if (doubted_.exchange(true)) return;
  note("the store has results, such as " + name +
       ", that came from elsewhere, or of which an earlier version does not say whence, and that "
       "no key has signed that is trusted; they are made again");
}

bool DiskStore::keep(const std::string& name, std::string_view bytes, const Origin& origin) {
  if (!writable_ || !is_store_name(name)) return false;
  const fs::path path = path_of(name);
  const bool blob = name.starts_with("cas/");
  if (blob && find(name)) return true;
  try {
    write(path, blob ? std::string(bytes) : sealed(name, Stored{std::string(bytes), origin}));
  } catch (const std::system_error& error) {
    if (writable_.exchange(false)) {
      note("results are not kept from here on: " + std::string(error.what()));
    }
    return false;
  }
  return true;
}

void DiskStore::write(const fs::path& path, std::string_view bytes) const {
  // Two letters of a hash, which only somebody else can have made a link.
  if (fs::is_symlink(path.parent_path())) fs::remove(path.parent_path());
  fs::create_directories(path.parent_path());
  std::string aside = (folder_ / "tmp" / "XXXXXX").string();
  const Descriptor file(mkostemp(aside.data(), O_CLOEXEC));
  if (file.get() < 0) throw_errno(aside);
  try {
    flock(file.get(), LOCK_EX);  // for as long as it is ours
    write_all(file.get(), bytes, aside);
    if (fsync(file.get()) != 0) throw_errno(aside);
    fs::rename(aside, path);
  } catch (...) {
    unlink(aside.c_str());
    throw;
  }
}

void DiskStore::note(std::string text) {
  const std::lock_guard lock(mutex_);
  notes_.push_back(std::move(text));
}

std::vector<std::string> DiskStore::notes() const {
  const std::lock_guard lock(mutex_);
  return notes_;
}

fs::path prepared_folder(const fs::path& folder) {
  return folder / "prepared";
}

namespace {

struct Entry {
  fs::path path;
  std::uintmax_t bytes = 0;
  fs::file_time_type used;
  bool is_prepared = false;  // and no result

  void count_in(Pruned::Count& count) const {
    ++(is_prepared ? count.prepared : count.results);
    count.bytes += bytes;
  }
};

// "ac/…" of the file that path_of() gives for it.
std::string name_of(const std::string& kind, const fs::path& file) {
  return kind + "/" + file.parent_path().filename().string() + file.filename().string();
}

// As mkostemp() has named it.
bool is_unfinished(const fs::directory_entry& entry) {
  return entry.is_regular_file() && !entry.is_symlink() &&
         entry.path().filename().string().size() == std::string_view("XXXXXX").size();
}

std::vector<Entry> entries_of(const fs::path& folder) {
  std::vector<Entry> entries;
  for (const char* kind : {"ac", "cas"}) {
    if (!fs::exists(folder / kind)) continue;
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder / kind)) {
      if (file.is_regular_file() && is_store_name(name_of(kind, file.path()))) {
        entries.push_back({file.path(), file.file_size(), file.last_write_time()});
      }
    }
  }
  if (!fs::exists(prepared_folder(folder))) return entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(prepared_folder(folder))) {
    std::error_code none;
    const fs::file_time_type used = fs::last_write_time(entry.path() / "current", none);
    FolderSize size;
    add_size(entry.path().string(), UINT64_MAX, size);
    entries.push_back({entry.path(), size.bytes, none ? fs::file_time_type::min() : used, true});
  }
  return entries;
}

// Nobody writes while the store is locked, so all that is here was left behind. What stands where a
// folder belongs is nothing of a store.
void clear_unfinished(const fs::path& folder) {
  for (const fs::path& path :
       {folder / "ac", folder / "cas", folder / "tmp", prepared_folder(folder)}) {
    const fs::file_status status = fs::symlink_status(path);
    if (fs::exists(status) && !fs::is_directory(status)) fs::remove(path);
  }
  if (!fs::exists(folder / "tmp")) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "tmp")) {
    if (is_unfinished(entry)) fs::remove(entry.path());
  }
}

}  // namespace

std::optional<Pruned> prune_store(const fs::path& folder, std::uintmax_t keep, bool wait) {
  if (!fs::exists(folder)) return Pruned{};
  refuse_other_folder(folder);
  const Descriptor lock(open_lock(folder));
  if (lock.get() < 0) throw_errno(folder / "lock");
  while (flock(lock.get(), LOCK_EX | (wait ? 0 : LOCK_NB)) != 0) {
    if (errno == EWOULDBLOCK) return std::nullopt;
    if (errno != EINTR) throw_errno(folder / "lock");
  }
  clear_unfinished(folder);
  std::vector<Entry> entries = entries_of(folder);
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.used, a.path) < std::pair(b.used, b.path);
  });
  Pruned pruned;
  std::uintmax_t bytes = 0;
  for (const Entry& entry : entries) bytes += entry.bytes;
  for (const Entry& entry : entries) {
    const bool goes = bytes > keep;
    if (goes) {
      fs::remove_all(entry.path);
      bytes -= entry.bytes;
    }
    entry.count_in(goes ? pruned.removed : pruned.left);
  }
  return pruned;
}

}  // namespace mjcourse
