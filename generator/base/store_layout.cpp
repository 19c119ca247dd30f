#include "base/store_layout.h"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "base/utf8.h"

namespace mjcourse {
namespace fs = std::filesystem;
namespace {

constexpr std::array kFiles{"lock", "pruned"};

}  // namespace

StorePlace StorePlace::of(const std::string& name) {
  const std::size_t hash = name.find('/') + 1;
  // What is sealed says itself of which kind it is.
  return {name.starts_with("cas/") ? "cas" : "ac", name.substr(hash, 2), name.substr(hash + 2)};
}

fs::path StorePlace::in(const fs::path& folder) const {
  return folder / kind / letters / file;
}

bool is_letters(std::string_view name) {
  return name.size() == 2 && name.find_first_not_of("0123456789abcdef") == name.npos;
}

fs::path prepared_folder(const fs::path& folder) {
  return folder / "prepared";
}

void refuse_other_folder(const fs::path& folder) {
  if (!fs::is_directory(folder)) return;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (std::ranges::count(kStoreFolders, name) + std::ranges::count(kFiles, name) > 0) continue;
    throw std::system_error(
        ENOTEMPTY, std::generic_category(),
        readable(folder.string()) + " is not a store, as it holds " + readable(name));
  }
}

Descriptor open_store_lock(const fs::path& folder) {
  return Descriptor(
      open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
}

Descriptor open_store_folder(int above, const std::string& name) {
  return Descriptor(openat(above, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

}  // namespace mjcourse
