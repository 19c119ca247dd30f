#include "base/disk_store.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "base/last_use.h"
#include "base/remove_folder.h"
#include "base/store_entry.h"
#include "base/utf8.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

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
  if (is_use_outdated(file)) utimensat(AT_FDCWD, path.c_str(), nullptr, 0);
}

// Does this failure befall all entries, and not just the one that was to be written?
bool is_of_disk(int reason) {
  return reason == ENOSPC || reason == EDQUOT || reason == EROFS || reason == EIO;
}

// An entry's place holds something that cannot be replaced.
struct Blocked {
  fs::path path;
  int reason;
};

[[noreturn]] void throw_blocked(const fs::path& path, int reason) {
  if (is_of_disk(reason)) throw std::system_error(reason, std::generic_category(), path.string());
  throw Blocked{path, reason};
}

// Nothing is written through a link, which only somebody else can have made.
bool is_link(const fs::path& path) {
  std::error_code unknown;
  return fs::is_symlink(fs::symlink_status(path, unknown));
}

// Anything else of this name is removed, since the name is the store's.
void make_folder(const fs::path& path) {
  if (mkdir(path.c_str(), 0777) == 0) return;
  struct stat status {};
  if (errno != EEXIST || lstat(path.c_str(), &status) != 0) throw_blocked(path, errno);
  if (S_ISDIR(status.st_mode)) return;
  if (unlink(path.c_str()) != 0 && errno != ENOENT) throw_blocked(path, errno);
  if (mkdir(path.c_str(), 0777) != 0 && errno != EEXIST) throw_blocked(path, errno);
}

}  // namespace

DiskStore::DiskStore(fs::path folder, Trust trust, const LockWait& wait)
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
  if (lock_.is_open()) lock(wait);
  const fs::path prepared = prepared_folder(folder_);
  if (fs::exists(prepared) && !fs::is_directory(prepared)) {
    note(prepared.string() + " is not a folder, so headers are compiled in each run; remove it");
  }
}

// A reader without the lock finds no half entries. It may miss an entry that is forgotten
// meanwhile, which Blob::bytes() tells.
void DiskStore::lock(const LockWait& wait) {
  const fs::path path = folder_ / "lock";
  if (take_lock(lock_.get(), LOCK_SH, path, wait)) return;
  if (writable_.exchange(false)) {
    note("the store is read and not written: " + lock_holder(lock_.get()) + " holds " +
         path.string() + "; end it, or use another store");
  }
}

// What it writes, and forgets, lies in itself: a link may lead anywhere.
void DiskStore::prepare() {
  refuse_other_folder(folder_);
  for (const char* kind : kStoreFolders) {
    if (!fs::is_symlink(folder_ / kind)) continue;
    throw std::system_error(ENOTDIR, std::generic_category(), (folder_ / kind).string());
  }
  fs::create_directories(folder_ / "tmp");
  if (eaccess((folder_ / "tmp").c_str(), W_OK) != 0) throw_errno(folder_ / "tmp");
  lock_ = open_store_lock(folder_);
  if (!lock_.is_open()) throw_errno(folder_ / "lock");
}

std::optional<Stored> DiskStore::find(const std::string& name) {
  if (!is_store_name(name)) return std::nullopt;
  const StorePlace place = StorePlace::of(name);
  const fs::path path = place.in(folder_);
  if (is_link(path.parent_path())) return std::nullopt;
  struct stat status {};
  std::optional<std::string> bytes = read_entry(path, status);
  if (!bytes || is_stored_by_another_version(*bytes)) return std::nullopt;
  std::optional<Stored> stored = unsealed_stored(name, *std::move(bytes));
  if (!stored) {
    note("the store's entry " + name + " was damaged; it is made again");
    if (writable_) clear(place);
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
  const StorePlace place = StorePlace::of(name);
  const bool blob = name.starts_with("cas/");
  if (blob && find(name)) return true;
  try {
    write(place, blob ? std::string(bytes) : sealed(name, Stored{std::string(bytes), origin}));
  } catch (const std::system_error& error) {
    if (writable_.exchange(false)) {
      note("results are not kept from here on: " + std::string(error.what()));
    }
    return false;
  } catch (const Blocked& blocked) {
    if (!blocked_.exchange(true)) {
      note("results such as " + name + " are not kept, as " + blocked.path.string() +
           " is in the way: " + std::generic_category().message(blocked.reason) + "; remove it");
    }
    return false;
  }
  return true;
}

// With all that lies there; by open folders, so no link leads elsewhere meanwhile.
std::error_code DiskStore::clear(const StorePlace& place) const {
  const Descriptor root(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  const Descriptor kind = open_store_folder(root.get(), place.kind);
  const Descriptor letters = open_store_folder(kind.get(), place.letters);
  if (!letters.is_open()) return {errno, std::generic_category()};
  return remove_folder(letters.get(), place.file);
}

void DiskStore::make_letters(const StorePlace& place) const {
  const fs::path kind = folder_ / place.kind, letters = kind / place.letters;
  struct stat status {};
  if (lstat(letters.c_str(), &status) == 0 && S_ISDIR(status.st_mode)) return;
  make_folder(kind);
  make_folder(letters);
}

void DiskStore::write(const StorePlace& place, std::string_view bytes) const {
  make_letters(place);
  const fs::path path = place.in(folder_);
  std::string aside = (folder_ / "tmp" / "XXXXXX").string();
  const Descriptor file(mkostemp(aside.data(), O_CLOEXEC));
  if (file.get() < 0) throw_errno(aside);
  try {
    write_all(file.get(), bytes, aside);
    if (fsync(file.get()) != 0) throw_errno(aside);
    if (rename(aside.c_str(), path.c_str()) == 0) return;
    if (errno != EISDIR) throw_blocked(path, errno);
    if (const std::error_code failure = clear(place)) throw_blocked(path, failure.value());
    if (rename(aside.c_str(), path.c_str()) != 0) throw_blocked(path, errno);
  } catch (...) {
    unlink(aside.c_str());
    throw;
  }
}

void DiskStore::note(std::string_view text) {
  const std::lock_guard lock(mutex_);
  notes_.push_back(readable(text));
}

std::vector<std::string> DiskStore::notes() const {
  const std::lock_guard lock(mutex_);
  return notes_;
}

}  // namespace mjcourse
