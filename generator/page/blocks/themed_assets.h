// ThemedAssets: what the site's build made, with the templates of a course's theme
// (course/theme.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "course/theme.h"
#include "page/blocks/page_writer.h"
#include "report/diagnostic.h"

namespace mjcourse {

// What the site's build made, but for templates: each is the one of the first of some folders that
// has it.
class ThemedAssets : public Files {
 public:
  ThemedAssets(const std::filesystem::path& assets,
               const std::vector<std::filesystem::path>& templates);

  // Has one of the folders a template?
  bool is_themed() const;

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;

 private:
  DiskFiles assets_;
  std::vector<DiskFiles> templates_;
};

// The mistake in a template, at its line in the course's theme, or else in the site's own; one of
// no single template at the theme's folder.
Diagnostic template_mistake(const TemplateError& error, const Files& course);

}  // namespace mjcourse
