#include "page/blocks/figure_data.h"

#include "page/html/site_paths.h"
#include "page/html/still_data.h"

namespace mjcourse {

nlohmann::json figure_data(const Figure& figure, std::size_t index, const LessonContext& context) {
  const auto* result = context.results.get<FigureResult>(index);
  const std::string path = "../" + block_path(context.lesson, index);
  const bool film = result != nullptr && !result->film.empty();
  nlohmann::json data{
      {"id", block_name(context.lesson, index)},
      {"film", film ? nlohmann::json(site_address(path) + ".mp4") : nlohmann::json(nullptr)},
      {"picture", nullptr},
      {"caption", context.inline_html(figure.caption)}};
  if (result == nullptr) return data;
  data["picture"] = still_data(path, figure.width, figure.height, figure.alt);
  return data;
}

}  // namespace mjcourse
