#include "cache/prepared_folders.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <exception>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/content_hash.h"
#include "base/file_lock.h"
#include "base/files.h"
#include "base/last_use.h"
#include "base/remove_folder.h"
#include "base/replace_file.h"
#include "base/utf8.h"
#include "cache/fingerprints.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Entry = PreparedFolders::Entry;

constexpr const char* kManifest = "current";
constexpr const char* kLock = "lock";
constexpr const char* kStaging = "making";
constexpr const char* kRefused = "refused";  // in the place of an entry's name
constexpr off_t kMostOfAHeader = 256 << 20;  // bytes, of a file that somebody's list may name

// As content_hash() makes them: a name, and no way to elsewhere.
bool is_entry_name(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, is_word_character);
}

// What `current` says: the entry's name, then a line "HASH NAME" for each input.
struct Manifest {
  std::string name;
  std::vector<std::pair<std::string, std::string>> inputs;

  std::string text() const {
    std::string text = name + "\n";
    for (const auto& [hash, path] : inputs) text.append(hash).append(" ").append(path) += '\n';
    return text;
  }
};

// Empty where there is no such file. Each program asks for the same hundreds.
std::string hash_of_file(const fs::path& path) {
  static FingerprintCache hashed;
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || status.st_size > kMostOfAHeader) return "";
  if (auto known = hashed.find(path.string(), status)) return *std::move(known);
  const auto bytes = read_file(path);
  if (!bytes) return "";
  std::string hash = content_hash(*bytes);
  hashed.keep(path.string(), status, hash);
  return hash;
}

Manifest manifest_of(const std::vector<std::string>& names,
                     const PreparedFolders::TruePath& true_path) {
  Manifest manifest;
  std::string all;
  for (const std::string& name : names) {
    manifest.inputs.emplace_back(hash_of_file(true_path(name)), name);
    all += manifest.inputs.back().first + name;
  }
  manifest.name = content_hash(all);
  return manifest;
}

std::optional<Manifest> read_manifest(const fs::path& folder) {
  const auto text = DiskFiles(folder).read(kManifest);
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  Manifest manifest;
  std::getline(lines, manifest.name);
  if (!is_entry_name(manifest.name) && manifest.name != kRefused) return std::nullopt;
  for (std::string hash, path; lines >> hash && lines.get() && std::getline(lines, path);) {
    manifest.inputs.emplace_back(hash, path);
  }
  return manifest;
}

void bring_to_disk(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && fsync(descriptor) == 0;
  const int reason = errno;
  if (descriptor >= 0) close(descriptor);
  if (!synced) throw std::system_error(reason, std::generic_category(), path.string());
}

bool holds_links(const fs::path& folder) {
  if (fs::is_symlink(folder)) return true;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_symlink()) return true;
  }
  return false;
}

// None is ours, and one would lead what we write elsewhere.
void remove_links(const fs::path& folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_symlink()) fs::remove(entry.path());
  }
}

// All that lies there goes, however deep it is: in a store, somebody else may have put it there.
void remove_whole(const fs::path& path) {
  if (const std::error_code failure = remove_folder(path)) {
    throw std::system_error(failure, path.string());
  }
}

// Of the files in a request and in its entries, which is all that is ever written there.
std::uintmax_t size_of(const fs::path& request) {
  std::uintmax_t bytes = 0;
  std::error_code none;
  const auto add = [&](const fs::path& path) {
    struct stat file {};
    if (lstat(path.c_str(), &file) != 0) return false;
    if (S_ISREG(file.st_mode)) bytes += static_cast<std::uintmax_t>(file.st_size);
    return S_ISDIR(file.st_mode);
  };
  for (const fs::directory_entry& file : fs::directory_iterator(request, none)) {
    if (!add(file.path())) continue;
    for (const fs::directory_entry& inner : fs::directory_iterator(file.path(), none)) {
      add(inner.path());
    }
  }
  return bytes;
}

LastUse use_of(const fs::path& request) {
  struct stat manifest {};
  if (lstat((request / kManifest).c_str(), &manifest) != 0) return {};
  return LastUse::of(manifest);
}

// Removes what was not used for longest, until the rest is small enough. `kept` stays, and what
// somebody uses or we may not remove.
void prune(const fs::path& all, const fs::path& kept, std::uintmax_t most_bytes) {
  std::vector<std::pair<LastUse, fs::path>> requests;
  std::uintmax_t bytes = 0;
  for (const fs::directory_entry& request : fs::directory_iterator(all)) {
    if (!fs::is_directory(request.symlink_status())) continue;
    bytes += size_of(request.path());
    if (request.path() != kept) requests.emplace_back(use_of(request.path()), request.path());
  }
  std::sort(requests.begin(), requests.end());
  for (const auto& [used, request] : requests) {
    if (bytes <= most_bytes) return;
    try {
      remove_links(request);
      const FileLock lock(request / kLock, LockWait::none());
      if (!lock.held()) continue;
      const std::uintmax_t size = size_of(request);
      remove_whole(request);
      bytes -= size;
    } catch (const std::system_error&) {
      // Another's, perhaps; the next one may be ours.
    }
  }
}

}  // namespace

PreparedFolders::Found PreparedFolders::look(const fs::path& folder) const {
  // The target of a link would be open to each program that is compiled with it.
  if (fs::is_symlink(folder)) return {};
  const std::optional<Manifest> manifest = read_manifest(folder);
  if (!manifest) return {};
  Entry entry{folder / manifest->name, {}};
  for (const auto& [hash, name] : manifest->inputs) {
    entry.inputs.push_back(true_path_(name));
    if (hash_of_file(entry.inputs.back()) != hash) return {};
  }
  std::sort(entry.inputs.begin(), entry.inputs.end());
  std::error_code ignored;  // somebody else's cache may be read, but not be written to
  fs::last_write_time(folder / kManifest, fs::file_time_type::clock::now(), ignored);
  if (manifest->name == kRefused) return {true, nullptr};
  if (!fs::is_directory(entry.folder) || holds_links(entry.folder)) return {};
  return {true, std::make_shared<const Entry>(std::move(entry))};
}

// Under the folder's lock.
std::shared_ptr<const Entry> PreparedFolders::make_anew(const fs::path& folder, const Make& make) {
  const fs::path staging = folder / kStaging;
  for (const fs::directory_entry& old : fs::directory_iterator(folder)) {
    // The last entry, and what a process left that was killed while it made one. A compiler that
    // reads the last entry just now says so, and its program is compiled without.
    if (old.is_directory()) remove_whole(old.path());
  }
  fs::create_directory(staging);
  std::optional<Made> made;
  try {
    made = make(folder, staging);
  } catch (...) {
    remove_folder(staging);  // what a full disk took of it
    throw;
  }
  if (!made) {
    remove_folder(staging);
    return nullptr;
  }
  Manifest manifest = manifest_of(made->inputs, true_path_);
  if (!made->worked) manifest.name = kRefused;
  if (made->worked) {
    for (const fs::directory_entry& file : fs::directory_iterator(staging)) {
      bring_to_disk(file.path());
    }
    fs::rename(staging, folder / manifest.name);
    bring_to_disk(folder);
  } else {
    remove_folder(staging);
  }
  const auto before = DiskFiles(folder).read(kManifest);
  replace_file(folder, kManifest, before ? std::optional(*before) : std::nullopt, manifest.text());
  return look(folder).entry;
}

std::shared_ptr<const Entry> PreparedFolders::find(const std::string& request) {
  if (!folder_) return nullptr;
  const std::lock_guard lock(mutex_);
  if (const auto known = found_.find(request); known != found_.end()) return known->second;
  try {
    const Found found = look(*folder_ / content_hash(request));
    if (found.current && found.entry) return found_[request] = found.entry;
  } catch (const std::system_error&) {
    // A cache that cannot be read is one that is not there.
  }
  return nullptr;
}

std::shared_ptr<const Entry> PreparedFolders::get(const std::string& request, const Make& make) {
  if (!folder_) return nullptr;
  std::promise<std::shared_ptr<const Entry>> promise;
  std::shared_future<std::shared_ptr<const Entry>> future;
  bool first = false;
  {
    const std::lock_guard lock(mutex_);
    const auto [place, added] = asked_.try_emplace(request);
    if (added) place->second = promise.get_future().share();
    future = place->second;
    first = added;
  }
  if (!first) return future.get();
  std::shared_ptr<const Entry> entry;
  try {
    entry = find_or_make(*folder_ / content_hash(request), make);
  } catch (const std::system_error&) {
    // A cache that cannot be read or written is one that is not there.
  } catch (...) {
    // The work was cancelled, which the waiting threads are told too.
    promise.set_exception(std::current_exception());
    throw;
  }
  promise.set_value(entry);
  return entry;
}

std::shared_ptr<const Entry> PreparedFolders::find_or_make(const fs::path& folder,
                                                           const Make& make) {
  if (const Found found = look(folder); found.current) return found.entry;
  // What is made anew removes what was there, and a link leads to what is somebody's.
  if (fs::is_symlink(folder)) fs::remove(folder);
  fs::create_directories(folder);
  remove_links(folder);
  const FileLock lock(folder / kLock, {.most = patience_});
  if (!lock.held()) return nullptr;
  // Somebody else may have made it while we waited.
  if (const Found found = look(folder); found.current) return found.entry;
  auto entry = make_anew(folder, make);
  prune(*folder_, folder, most_bytes_);
  return entry;
}

void PreparedFolders::drop(const Entry& entry) {
  std::error_code ignored;
  fs::remove(entry.folder.parent_path() / kManifest, ignored);
}

}  // namespace mjcourse
