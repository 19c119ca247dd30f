// DiskStore: a Store in a folder, shared by all runs of a user.
//
//     cas/77/b0c4…  the bytes
//     ac/3f/2a91…   sealed bytes (store_entry.h), of all other kinds of names, and where they are
//     from tmp/XXXXXX    what is being written, and what a killed process left of that prepared/…
//     folders of what programs share (cache/prepared_folders.h) lock          held shared by each
//     run, and alone by the one that prunes
//
// An entry is written aside, synced and renamed, so it is there as a whole or not at all; and it is
// verified whenever it is read, since disks and people damage files too. A damaged entry is removed
// with a note. What is read counts as used, at most once an hour.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "base/descriptor.h"
#include "base/store.h"

namespace mjcourse {

class DiskStore : public Store {
 public:
  // Makes the folder; where it is there and cannot be written, it is read alone. Throws
  // std::system_error where it cannot be used at all. What `trust` does not believe is a miss.
  explicit DiskStore(std::filesystem::path folder, Trust trust = {});
  DiskStore(const DiskStore&) = delete;
  DiskStore& operator=(const DiskStore&) = delete;

  std::optional<Stored> find(const std::string& name) override;
  // After the first entry that cannot be written (a full disk), no more are tried.
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override;

  const std::filesystem::path& folder() const { return folder_; }
  bool can_be_written() const { return writable_; }
  // Sentences for the user: of a damaged entry, of a full disk, of an entry that nobody who is
  // trusted has signed.
  std::vector<std::string> notes() const;

 private:
  std::filesystem::path path_of(const std::string& name) const;
  void prepare();
  void write(const std::filesystem::path& path, std::string_view bytes) const;
  void note(std::string text);
  void note_doubt(const std::string& name);

  std::filesystem::path folder_;
  Trust trust_;
  std::atomic<bool> doubted_ = false;  // and said so
  Descriptor lock_;
  std::atomic<bool> writable_ = true;
  mutable std::mutex mutex_;  // of the notes
  std::vector<std::string> notes_;
};

// Where a store in `folder` has what is not of one file: each folder in there is an entry, which is
// used when the file `current` in it is touched.
std::filesystem::path prepared_folder(const std::filesystem::path& folder);

struct Pruned {
  struct Count {
    std::uintmax_t results = 0, prepared = 0, bytes = 0;
  };
  Count removed, left;
};

// Remove the entries that were not used for longest until the store in `folder` holds at most
// `keep` bytes, and what killed processes left. Throws std::system_error where it is none, or
// cannot be written. Waits for runs that use the store; nothing is done, and nothing given, where
// `wait` is false and there is one.
std::optional<Pruned> prune_store(const std::filesystem::path& folder, std::uintmax_t keep,
                                  bool wait);

}  // namespace mjcourse
