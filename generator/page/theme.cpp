#include "page/theme.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "base/nearest.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

constexpr std::string_view kTemplates = "templates/", kEnding = ".hbs";

std::string theme_path(const std::string& template_name) {
  return std::string(kThemeTemplates) + "/" + template_name + std::string(kEnding);
}

// The names of the templates that `text` includes: `{{> name`.
std::set<std::string> partials_in(std::string_view text) {
  std::set<std::string> names;
  for (std::size_t at = 0; (at = text.find("{{", at)) != text.npos;) {
    at = text.find_first_not_of("~{ ", at);
    if (at == text.npos || text[at] != '>') continue;
    const std::size_t begin = std::min(text.find_first_not_of(' ', at + 1), text.size());
    const std::size_t end = std::min(text.find_first_of(" }~", begin), text.size());
    names.insert(std::string(text.substr(begin, end - begin)));
  }
  return names;
}

// A template's name, of its file's; nothing where it is none.
std::optional<std::string> template_name(const std::string& file) {
  if (!file.ends_with(kEnding)) return std::nullopt;
  return file.substr(0, file.size() - kEnding.size());
}

Diagnostic stray(const std::string& file, const std::string& message, const std::string& cure) {
  Place place;
  place.file = file;
  return error_at(std::move(place), "E-theme-file", message, cure);
}

}  // namespace

ThemedAssets::ThemedAssets(const std::filesystem::path& assets,
                           const std::vector<std::filesystem::path>& templates)
    : assets_(assets) {
  for (const std::filesystem::path& folder : templates) templates_.emplace_back(folder);
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

Diagnostics check_theme(const Files& course, const Files& assets) {
  Diagnostics diagnostics;
  std::vector<std::string> known;
  for (const std::string& file : assets.list("templates")) {
    if (const auto name = template_name(file)) known.push_back(*name);
  }
  std::set<std::string> used(known.begin(), known.end());
  const auto check = [&](const std::string& path) {
    const std::string why = course.refusal(path);
    if (!why.empty()) diagnostics.push_back(refused_file({path, 0, 0, 1, ""}, path, why));
    return why.empty();
  };
  if (!check("theme")) return diagnostics;
  check(kThemeTemplates);
  const std::vector<std::string> files = course.list(kThemeTemplates);
  for (const std::string& file : files) {
    used.merge(partials_in(course.read(std::string(kThemeTemplates) + "/" + file).value_or("")));
  }
  for (const std::string& file : files) {
    if (!check(std::string(kThemeTemplates) + "/" + file)) continue;
    const auto name = template_name(file);
    if (name && used.contains(*name)) continue;
    diagnostics.push_back(stray(std::string(kThemeTemplates) + "/" + file,
                                name ? "no template has this name, and none includes it"
                                     : "a template is a file `NAME.hbs`",
                                name ? suggest(*name, known) : ""));
  }
  for (const std::string& file : course.list("theme")) {
    if (!check("theme/" + file) || "theme/" + file == kThemeStyle) continue;
    diagnostics.push_back(stray("theme/" + file, "a theme has no such file",
                                "its styles are `style.css`, its templates `templates/NAME.hbs`"));
  }
  return diagnostics;
}

bool is_themed(const std::string& template_name, const Files& course) {
  return course.exists(theme_path(template_name));
}

Diagnostic template_mistake(const TemplateError& error, const Files& course) {
  const std::string path = theme_path(error.name);
  const auto text = course.read(path);
  if (text && error.line > 0) {
    const SourceText source(path, *text);
    const int line = std::min(error.line, source.line_count());
    const std::size_t begin = source.line_start(line);
    return error_at(place_of(source, {begin, begin + source.line(line).size()}), "E-template",
                    error.message);
  }
  Place place;
  place.file = text ? path : "site/" + std::string(kTemplates) + error.name + std::string(kEnding);
  place.line = error.line;
  return error_at(std::move(place), "E-template", error.message);
}

}  // namespace mjcourse
