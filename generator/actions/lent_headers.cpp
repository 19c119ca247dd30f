#include "actions/lent_headers.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/cpp_includes.h"
#include "base/files.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A compiler looks beside the file that includes, and then beside the program.
std::optional<std::string> find_header(const DiskFiles& files, const fs::path& folder,
                                       const std::string& name) {
  for (const fs::path& candidate : {(folder / name).lexically_normal(), fs::path(name)}) {
    if (files.read(candidate)) return candidate;
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> included_headers(const DiskFiles& files, std::string_view program) {
  std::set<std::string> found;
  // Not by recursion: a chain of headers may have any length.
  std::vector<std::pair<fs::path, std::string>> open{{"", std::string(program)}};
  while (!open.empty()) {
    const auto [folder, text] = std::move(open.back());
    open.pop_back();
    for (const std::string& name : quoted_includes(text)) {
      const auto header = find_header(files, folder, name);
      if (!header || !found.insert(*header).second) continue;
      open.emplace_back(fs::path(*header).parent_path(), files.read(*header).value_or(""));
    }
  }
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
