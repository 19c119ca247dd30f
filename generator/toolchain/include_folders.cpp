#include "toolchain/include_folders.h"

#include <algorithm>

#include "base/files.h"

namespace mjcourse {

namespace fs = std::filesystem;

namespace {

// Is all that its programs include to be read? A compiler waits for ever at a pipe.
bool is_sound(const DiskFiles& course) {
  if (course.refusal("examples/include")) return false;
  const std::vector<std::string> headers = course.list_below("examples/include");
  return std::all_of(headers.begin(), headers.end(), [&](const std::string& name) {
    return !course.refusal("examples/include/" + name);
  });
}

}  // namespace

IncludeFolders include_folders_of(const fs::path& examples, const fs::path& helper) {
  IncludeFolders folders;
  // What is refused is nobody's to compile; read_course() tells of it.
  if (is_sound(DiskFiles(examples.parent_path()))) folders.push_back(examples / "include");
  const bool has_helper = !folder_with(kHelperHeader, folders).empty();
  if (!has_helper && !helper.empty()) folders.push_back(helper);
  return folders;
}

fs::path folder_with(const std::string& name, const IncludeFolders& folders) {
  for (const fs::path& folder : folders) {
    if (fs::exists(folder / name)) return folder;
  }
  return {};
}

fs::path handlers_source(const IncludeFolders& folders) {
  for (const fs::path& folder : folders) {
    fs::path source = folder / "mjcourse" / "handlers.cpp";
    if (fs::exists(source)) return source;
  }
  return {};
}

std::vector<fs::path> read_for(const IncludeFolders& folders) {
  std::vector<fs::path> read;
  for (const fs::path& folder : folders) read.push_back(folder.parent_path());
  return read;
}

}  // namespace mjcourse
