#include "page/html/uses_data.h"

#include "page/html/reader_text.h"
#include "page/html/site_paths.h"

namespace mjcourse {

nlohmann::json uses_data(const std::vector<Use>& uses, const Evaluation& evaluation,
                         const std::string& root) {
  nlohmann::json pages = nlohmann::json::array();
  const Lesson* last = nullptr;
  for (const Use& use : uses) {
    const Lesson& page = *use.page;
    const std::string href = root + site_address(page_path(page));
    if (use.page != last) {
      pages.push_back({{"number", page.number},
                       {"title", page.front.title.text},
                       {"href", href},
                       {"sections", nlohmann::json::array()}});
    }
    last = use.page;
    if (use.section == nullptr) continue;
    pages.back()["sections"].push_back(
        {{"title", reader_text(*use.section, evaluation.results_of(page))},
         {"href", href + "#" + use.section->id}});
  }
  return pages;
}

}  // namespace mjcourse
