#include "base/folder_names.h"

#include <dirent.h>
#include <fcntl.h>

#include "base/descriptor.h"

namespace mjcourse {

std::vector<std::string> names_in_folder(int folder) {
  std::vector<std::string> names;
  Descriptor copy(openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  DIR* const entries = copy.is_open() ? fdopendir(copy.get()) : nullptr;
  if (entries == nullptr) return names;
  copy.release();
  while (const dirent* entry = readdir(entries)) {
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  closedir(entries);
  return names;
}

}  // namespace mjcourse
