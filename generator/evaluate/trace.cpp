#include "evaluate/trace.h"

#include "evaluate/dependency.h"

namespace mjcourse {

namespace fs = std::filesystem;

Trace::Trace(const fs::path& root) : root_(fs::absolute(root).lexically_normal()) {}

void Trace::clear() {
  names_.clear();
  complete_ = true;
}

bool Trace::file(const fs::path& path) {
  const fs::path whole = (root_ / path).lexically_normal();
  const fs::path below = whole.lexically_relative(root_);
  const bool inside = !below.empty() && *below.begin() != "..";
  return names_.insert((inside ? below : whole).string()).second;
}

void Trace::program(const std::string& name) {
  names_.insert(program_dependency(name));
}

tl::expected<std::string, std::string> TracedFiles::read(const std::string& path) const {
  trace_.file(path);
  return files_.read(path);
}

bool TracedFiles::exists(const std::string& path) const {
  trace_.file(path);
  return files_.exists(path);
}

std::vector<std::string> TracedFiles::list(const std::string& folder) const {
  trace_.file(folder);
  return files_.list(folder);
}

}  // namespace mjcourse
