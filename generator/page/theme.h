// The theme: what a course says of how its site looks, where it wants another look than it is
// given.
//
//   theme/templates/NAME.hbs   stands in the place of the site's template of that name; others are
//                              partials of these
//   theme/style.css            is loaded behind the site's stylesheet, whose rules are all in
//                              layers: so each rule here wins. Colours, faces and sizes are custom
//                              properties (site/styles/tokens.css).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "page/page_writer.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Below the course's folder.
inline constexpr const char* kThemeTemplates = "theme/templates";
inline constexpr const char* kThemeStyle = "theme/style.css";

// What the site's build made, but for templates: each is the one of the first of some folders that
// has it.
class ThemedAssets : public Files {
 public:
  ThemedAssets(const std::filesystem::path& assets,
               const std::vector<std::filesystem::path>& templates);

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;

 private:
  DiskFiles assets_;
  std::vector<DiskFiles> templates_;
};

// What is wrong with the theme of a course, where it has one: names that stand for nothing. What
// its templates do is seen when pages are written.
Diagnostics check_theme(const Files& course, const Files& assets);

// Has the course a template of that name?
bool is_themed(const std::string& template_name, const Files& course);

// The mistake in a template, at its line in the course's theme, or else in the site's own.
Diagnostic template_mistake(const TemplateError& error, const Files& course);

}  // namespace mjcourse
