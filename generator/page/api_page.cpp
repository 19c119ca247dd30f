#include "page/api_page.h"

#include "course/link_target.h"
#include "course/uses.h"
#include "page/html/anchors.h"
#include "page/html/site_paths.h"
#include "page/html/uses_data.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostUseLines = 5;  // that are linked to, of one program
constexpr std::size_t kMostPrograms = 2;  // whose lines are shown at once

// The sections that speak of it, or have code that does, but for programs.
json sections_data(const ApiEntry& entry, const Course& course, const Evaluation& evaluation) {
  std::vector<Use> uses = uses_of_link(course, "api:" + entry.name);
  const std::vector<const Lesson*> pages = course.pages();
  std::vector<PlaceOnPage> places;
  for (const CodeUse& use : entry.uses_in_code) {
    if (use.lines.empty()) places.push_back({pages[use.page], use.place});
  }
  add_uses(uses, places, course);
  return uses_data(uses, evaluation, "");
}

json lines_data(const CodeUse& use) {
  json lines = json::array();
  for (const int line : use.lines) {
    if (lines.size() == kMostUseLines) break;
    lines.push_back({{"line", line}});
  }
  return lines;
}

json programs_data(const ApiEntry& entry, const Course& course) {
  const std::vector<const Lesson*> pages = course.pages();
  json programs = json::array();
  for (const CodeUse& use : entry.uses_in_code) {
    if (use.lines.empty()) continue;
    const Lesson& page = *pages[use.page];
    const auto& program = std::get<Example>(page.blocks[use.block]);
    const std::string href = site_address(page_path(page)) + "#" + example_anchor(program);
    if (!programs.empty() && programs.back()["href"] == href) continue;  // shown twice
    programs.push_back({{"number", page.number},
                        {"file", program.name() + ".cpp"},
                        {"href", href},
                        {"lines", lines_data(use)},
                        {"more", use.lines.size() > kMostUseLines}});
  }
  return programs;
}

}  // namespace

std::string api_page(const Course& course, const Evaluation& evaluation,
                     const PageContext& context) {
  json names = json::array();
  for (const ApiEntry& entry : evaluation.api) {
    json programs = programs_data(entry, course);
    const std::size_t many = programs.size() > kMostPrograms ? programs.size() : 0;
    names.push_back({{"id", api_id(entry.name)},
                     {"name", entry.name},
                     {"kind", entry.kind},
                     {"declaration", context.highlighter.highlight(entry.declaration, "c")},
                     {"comment", entry.comment},
                     {"header", entry.header},
                     {"section", entry.section},
                     {"url", entry.url},
                     {"uses", sections_data(entry, course, evaluation)},
                     {"programs", std::move(programs)},
                     {"many", many}});
  }
  return render_template(
      context.templates, "api",
      {{"title", kApiTitle}, {"mujoco", evaluation.versions.mujoco}, {"names", std::move(names)}});
}

}  // namespace mjcourse
