#include "cache/trace.h"

#include "cache/dependency_sets.h"

namespace mjcourse {

namespace fs = std::filesystem;

Trace::Trace(const fs::path& root) : root_(fs::absolute(root).lexically_normal()) {}

void Trace::clear() {
  names_.clear();
  sets_.clear();
  headers_.clear();
  found_.clear();
  origin_ = {};
  complete_ = true;
}

bool Trace::file(const fs::path& path) {
  return names_.insert(file_dependency(path, root_)).second;
}

void Trace::files(const std::vector<std::string>& paths) {
  std::vector<std::string> others;
  for (const std::string& path : paths) {
    std::string name = file_dependency(path, root_);
    if (name.starts_with('/')) {
      others.push_back(std::move(name));
    } else {
      names_.insert(std::move(name));
    }
  }
  if (!others.empty()) sets_.insert(std::move(others));
}

void Trace::headers_in(const fs::path& folder, const std::vector<std::string>& paths) {
  std::set<std::string>& names = headers_[file_dependency(folder, root_)];
  for (const std::string& path : paths) names.insert(fs::path(path).filename());
}

void Trace::program(const std::string& name) {
  names_.insert(program_dependency(name));
}

void Trace::add(const Trace& other) {
  add(other.names_);
  sets_.insert(other.sets_.begin(), other.sets_.end());
  for (const auto& [folder, headers] : other.headers_) {
    headers_[folder].insert(headers.begin(), headers.end());
  }
  found_.insert(found_.end(), other.found_.begin(), other.found_.end());
  origin_.add(other.origin_);
  complete_ = complete_ && other.complete_;
}

void Trace::found(const Dependencies& traced, const Origin& origin) {
  origin_.add(origin);
  for (const auto& [name, value] : traced) {
    found_.push_back({name, value});
    if (!DependencySets::is_name(name)) names_.insert(name);
  }
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

std::vector<std::string> TracedFiles::list_below(const std::string& folder) const {
  trace_.unknown();  // which folders there are, cannot be named
  return files_.list_below(folder);
}

std::optional<FileRefusal> TracedFiles::refusal(const std::string& path) const {
  trace_.file(path);
  return files_.refusal(path);
}

}  // namespace mjcourse
