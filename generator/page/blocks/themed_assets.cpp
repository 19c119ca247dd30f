#include "page/blocks/themed_assets.h"

#include <algorithm>
#include <set>
#include <string_view>

namespace mjcourse {
namespace {

constexpr std::string_view kTemplates = "templates/";

}  // namespace

ThemedAssets::ThemedAssets(const std::filesystem::path& assets,
                           const std::vector<std::filesystem::path>& templates)
    : assets_(assets) {
  for (const std::filesystem::path& folder : templates) templates_.emplace_back(folder);
}

bool ThemedAssets::is_themed() const {
  return std::ranges::any_of(templates_, [](const DiskFiles& folder) {
    return std::ranges::any_of(folder.list(""),
                               [](const std::string& name) { return name.ends_with(".hbs"); });
  });
}

tl::expected<std::string, std::string> ThemedAssets::read(const std::string& path) const {
  if (path.starts_with(kTemplates)) {
    const std::string name = path.substr(kTemplates.size());
    for (const DiskFiles& folder : templates_) {
      if (folder.exists(name)) return folder.read(name);
    }
  }
  return assets_.read(path);
}

bool ThemedAssets::exists(const std::string& path) const {
  return read(path).has_value();
}

std::vector<std::string> ThemedAssets::list(const std::string& folder) const {
  std::vector<std::string> names = assets_.list(folder);
  if (folder + "/" != kTemplates) return names;
  std::set<std::string> all(names.begin(), names.end());
  for (const DiskFiles& one : templates_) {
    for (const std::string& name : one.list("")) all.insert(name);
  }
  return {all.begin(), all.end()};
}

std::vector<std::string> ThemedAssets::list_below(const std::string& folder) const {
  std::vector<std::string> names = assets_.list_below(folder);
  if (folder + "/" != kTemplates) return names;
  std::set<std::string> all(names.begin(), names.end());
  for (const DiskFiles& one : templates_) {
    for (const std::string& name : one.list_below("")) all.insert(name);
  }
  return {all.begin(), all.end()};
}

Diagnostic template_mistake(const TemplateError& error, const Files& course) {
  const std::string path = theme_template(error.name);
  const auto text = course.read(path);
  if (text && error.line > 0) {
    const SourceText source(path, *text);
    const int line = std::min(error.line, source.line_count());
    const std::size_t begin = source.line_start(line);
    return error_at(place_of(source, {begin, begin + source.line(line).size()}), "E-template",
                    error.message, error.cure);
  }
  Place place;
  place.file = text ? path : "site/press/" + std::string(kTemplates) + error.name + ".hbs";
  if (error.name.empty()) place.file = kThemeTemplates;
  place.line = error.line;
  return error_at(std::move(place), "E-template", error.message, error.cure);
}

}  // namespace mjcourse
