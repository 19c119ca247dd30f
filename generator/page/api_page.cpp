#include "page/api_page.h"

#include "course/link_target.h"
#include "course/uses.h"
#include "page/uses_data.h"

namespace mjcourse {

std::string api_page(const Course& course, const Evaluation& evaluation, const Press& press) {
  nlohmann::json names = nlohmann::json::array();
  for (const ApiEntry& entry : evaluation.api) {
    names.push_back(
        {{"id", api_id(entry.name)},
         {"name", entry.name},
         {"kind", entry.kind},
         {"declaration", press.highlighter.highlight(entry.declaration, "c")},
         {"comment", entry.comment},
         {"header", entry.header},
         {"section", entry.section},
         {"url", entry.url},
         {"uses", uses_data(uses_of_link(course, "api:" + entry.name), course, evaluation, "")}});
  }
  return render_template(
      press.templates, "api",
      {{"title", kApiTitle}, {"mujoco", evaluation.versions.mujoco}, {"names", std::move(names)}});
}

}  // namespace mjcourse
