#include "course/theme.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "base/editor_files.h"
#include "base/nearest.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

constexpr std::string_view kTemplateEnding = ".hbs";

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
  if (!file.ends_with(kTemplateEnding)) return std::nullopt;
  return file.substr(0, file.size() - kTemplateEnding.size());
}

// Without what an editor left there.
std::vector<std::string> of_author(std::vector<std::string> names) {
  std::erase_if(names, is_of_editor);
  return names;
}

Diagnostic stray(const std::string& file, const std::string& message, const std::string& cure) {
  Place place;
  place.file = file;
  return error_at(std::move(place), "E-theme-file", message, cure);
}

}  // namespace

std::string theme_template(const std::string& name) {
  return std::string(kThemeTemplates) + "/" + name + std::string(kTemplateEnding);
}

Diagnostics check_theme(const Files& course, const Files& assets) {
  Diagnostics diagnostics;
  std::vector<std::string> known;
  for (const std::string& file : assets.list("templates")) {
    if (const auto name = template_name(file)) known.push_back(*name);
  }
  std::set<std::string> used(known.begin(), known.end());
  const auto check = [&](const std::string& path) {
    const auto refusal = course.refusal(path);
    if (refusal) diagnostics.push_back(refused_file({path, 0, 0, 1, ""}, path, *refusal));
    return !refusal;
  };
  if (!check("theme")) return diagnostics;
  check(kThemeTemplates);
  const std::vector<std::string> files = of_author(course.list(kThemeTemplates));
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
                                name ? suggest(*name, known) : "name it so, or remove it"));
  }
  for (const std::string& folder : of_author(course.folders(kThemeTemplates))) {
    diagnostics.push_back(stray(std::string(kThemeTemplates) + "/" + folder,
                                "a template is a file `NAME.hbs`, not a folder",
                                "put what is in it into `theme/templates/` itself"));
  }
  const auto complain = [&](const std::string& name, const std::string& what) {
    diagnostics.push_back(stray("theme/" + name, "a theme has no such " + what,
                                "its styles are `style.css`, its templates `templates/NAME.hbs`"));
  };
  for (const std::string& file : of_author(course.list("theme"))) {
    if (check("theme/" + file) && "theme/" + file != kThemeStyle) complain(file, "file");
  }
  for (const std::string& folder : of_author(course.folders("theme"))) {
    if ("theme/" + folder != kThemeTemplates) complain(folder, "folder");
  }
  return diagnostics;
}

bool is_themed(const std::string& template_name, const Files& course) {
  return course.exists(theme_template(template_name));
}

}  // namespace mjcourse
