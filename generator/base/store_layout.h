// What lies in the folder of a DiskStore, and nowhere deeper:
//
//     cas/77/b0c4…  the bytes
//     ac/3f/2a91…   sealed bytes (store_entry.h), of all other kinds of names
//     tmp/XXXXXX    what is being written, and what a killed process left of that
//     prepared/…    folders of what programs share (cache/prepared_folders.h)
//     lock          held shared by each run, and alone by the one that prunes
//     pruned        has the time of the last pruning
//
// Tested by tests/generator/base/disk_store_test.cpp.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace mjcourse {

// The folders among these.
inline constexpr std::array kStoreFolders{"ac", "cas", "tmp", "prepared"};

// Where the entry of a name lies: in `kind`, in `letters`, as `file`.
struct StorePlace {
  std::string kind, letters, file;

  static StorePlace of(const std::string& name);
  std::filesystem::path in(const std::filesystem::path& folder) const;
};

// Two of the letters that a hash begins with.
bool is_letters(std::string_view name);

// Where a store in `folder` has what is not of one file: each folder in there is an entry, which is
// used when the file `current` in it is touched.
std::filesystem::path prepared_folder(const std::filesystem::path& folder);

// What a store removes is its own, so a folder with anything else in it is none: throws
// std::system_error.
void refuse_other_folder(const std::filesystem::path& folder);

// Of the store's file; not open where that cannot be made.
Descriptor open_store_lock(const std::filesystem::path& folder);

// A folder in the open one, and no link to one; not open where there is none.
Descriptor open_store_folder(int above, const std::string& name);

}  // namespace mjcourse
