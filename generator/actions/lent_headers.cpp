#include "actions/lent_headers.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/cpp_includes.h"
#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// The headers that a file in `folder` of `files` includes, with what these include.
void add_included(const DiskFiles& files, std::string_view text, const fs::path& folder,
                  std::set<std::string>& found) {
  for (const std::string& name : quoted_includes(text)) {
    // A compiler looks beside the file first, and then beside the program.
    for (const fs::path& candidate : {(folder / name).lexically_normal(), fs::path(name)}) {
      if (found.contains(candidate)) break;
      const auto header = files.read(candidate);
      if (!header) continue;
      found.insert(candidate);
      add_included(files, *header, candidate.parent_path(), found);
      break;
    }
  }
}

}  // namespace

std::vector<std::string> included_headers(const DiskFiles& files, std::string_view program) {
  std::set<std::string> found;
  add_included(files, program, "", found);
  return {found.begin(), found.end()};
}

LentHeaders::LentHeaders(fs::path from, fs::path to, std::string_view program)
    : from_(std::move(from)) {
  if (from_.empty()) return;
  const DiskFiles files(from_);
  const std::vector<std::string> found = included_headers(files, program);
  for (const std::string& name : found) {
    fs::create_directories((to / name).parent_path());
    write_file(to / name, files.read(name).value());
  }
  if (!found.empty()) to_ = std::move(to);
}

std::string LentHeaders::original_of(const std::string& path) const {
  const std::string copies = to_.string() + "/";
  return path.starts_with(copies) ? from_ / path.substr(copies.size()) : fs::path(path);
}

void LentHeaders::name_originals(Compiled& compiled) const {
  if (to_.empty()) return;
  for (CompilerMessage& message : compiled.messages) message.file = original_of(message.file);
  if (!compiled.dependencies) return;
  for (std::string& file : *compiled.dependencies) file = original_of(file);
  std::ranges::sort(*compiled.dependencies);
}

}  // namespace mjcourse
