#include "page/gallery_page.h"

#include <utility>

#include "course/link_target.h"
#include "course/uses.h"
#include "page/html/site_paths.h"
#include "page/html/uses_data.h"
#include "page/model_page.h"

namespace mjcourse {

std::string gallery_page(const Course& course, const Evaluation& evaluation,
                         const PageContext& context) {
  nlohmann::json models = nlohmann::json::array();
  for (const ModelPage& model : evaluation.models) {
    const nlohmann::json sizes = sizes_data(model);
    nlohmann::json uses = uses_data(uses_of_model(course, model.name), evaluation, "");
    // The sections stand on the model's own page.
    for (nlohmann::json& page : uses) page["sections"] = nlohmann::json::array();
    const Loaded loaded = models.empty() ? Loaded::at_once : Loaded::when_near;
    models.push_back({{"name", model.name},
                      {"href", site_address(model_page_path(model.name))},
                      {"poster", poster_data(model, "", loaded)},
                      {"sizes", {sizes.at(0), sizes.at(1), sizes.at(2)}},
                      {"uses", std::move(uses)}});
  }
  return render_template(context.templates, "gallery",
                         {{"title", kGalleryTitle}, {"models", std::move(models)}});
}

}  // namespace mjcourse
