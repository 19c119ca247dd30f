#include "lsp/open_documents.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/utf8.h"
#include "lsp/file_uri.h"

namespace mjcourse {
namespace {

std::optional<std::string> name_below(const std::filesystem::path& path,
                                      const std::filesystem::path& root) {
  std::string name = path.lexically_relative(root).string();
  const bool is_below = !name.empty() && name != "." && name != ".." && !name.starts_with("../");
  return is_below ? std::optional(std::move(name)) : std::nullopt;
}

}  // namespace

OpenDocuments::OpenDocuments(const std::filesystem::path& root)
    : root_((root / "").lexically_normal()), saved_(root_) {}

// An editor may name a file by another way than the course: through a symbolic link.
std::optional<std::string> OpenDocuments::name_of(std::string_view uri) const {
  const auto path = path_of(uri);
  if (!path) return std::nullopt;
  if (auto name = name_below(*path, root_)) return name;
  std::error_code none;
  return name_below(std::filesystem::weakly_canonical(*path, none),
                    std::filesystem::weakly_canonical(root_, none));
}

std::string OpenDocuments::uri_of(const std::string& name) const {
  return mjcourse::uri_of(root_ / name);
}

std::vector<OpenDocuments::Change> OpenDocuments::read_changes(const nlohmann::json& changes) {
  std::vector<Change> read;
  for (const nlohmann::json& one : changes) {
    const bool part = one.contains("range");
    read.push_back({part ? std::optional(read_range(one.at("range"))) : std::nullopt,
                    one.at("text").get<std::string>()});
  }
  return read;
}

void OpenDocuments::open(const std::string& name, std::string text) {
  auto opened = std::make_shared<const SourceText>(name, std::move(text));
  const std::lock_guard lock(mutex_);
  open_[name] = std::move(opened);
}

void OpenDocuments::change(const std::string& name, const std::vector<Change>& changes,
                           Units units) {
  auto now = text(name);
  if (!now) return;
  for (const Change& change : changes) {
    std::string text(now->text());
    const std::size_t begin = change.range ? offset_of(*now, change.range->begin, units) : 0;
    const std::size_t end = change.range ? offset_of(*now, change.range->end, units) : text.size();
    text.replace(begin, std::max(begin, end) - begin, change.text);
    now = std::make_shared<const SourceText>(name, std::move(text));
  }
  const std::lock_guard lock(mutex_);
  open_[name] = std::move(now);
}

void OpenDocuments::close(const std::string& name) {
  const std::lock_guard lock(mutex_);
  open_.erase(name);
}

std::vector<std::string> OpenDocuments::names() const {
  std::vector<std::string> names;
  const std::lock_guard lock(mutex_);
  for (const auto& [name, text] : open_) names.push_back(name);
  return names;
}

std::shared_ptr<const SourceText> OpenDocuments::text(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  const auto found = open_.find(name);
  return found == open_.end() ? nullptr : found->second;
}

std::shared_ptr<const SourceText> OpenDocuments::text_or_saved(const std::string& name) const {
  if (auto opened = text(name)) return opened;
  auto saved = saved_.read(name);
  if (!saved || find_invalid_utf8(*saved)) return nullptr;
  return std::make_shared<const SourceText>(name, *std::move(saved));
}

tl::expected<std::string, std::string> OpenDocuments::read(const std::string& path) const {
  if (const auto opened = text(path)) return std::string(opened->text());
  return saved_.read(path);
}

bool OpenDocuments::exists(const std::string& path) const {
  return text(path) != nullptr || saved_.exists(path);
}

std::optional<FileRefusal> OpenDocuments::refusal(const std::string& path) const {
  return saved_.refusal(path);
}

std::vector<std::string> OpenDocuments::folders(const std::string& folder) const {
  return saved_.folders(folder);
}

std::vector<std::string> OpenDocuments::list(const std::string& folder) const {
  std::vector<std::string> names = saved_.list(folder);
  const std::lock_guard lock(mutex_);
  for (const auto& [name, text] : open_) {
    const std::filesystem::path path(name);
    if (path.parent_path() == std::filesystem::path(folder)) names.push_back(path.filename());
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::vector<std::string> OpenDocuments::list_below(const std::string& folder) const {
  std::vector<std::string> names = saved_.list_below(folder);
  const std::lock_guard lock(mutex_);
  for (const auto& [name, text] : open_) {
    if (auto below = name_below(name, folder)) names.push_back(*std::move(below));
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

}  // namespace mjcourse
