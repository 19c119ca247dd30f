// The data that the template of a figure is fed with; its own comment describes it.
#include "page/blocks/page_writer.h"
#include "page/html/site_paths.h"
#include "page/html/still_data.h"

namespace mjcourse {

nlohmann::json PageWriter::data_of(const Figure& figure, std::size_t index) {
  const auto* result = results_.get<FigureResult>(index);
  const std::string path = "../" + block_path(lesson_, index);
  const bool film = result != nullptr && !result->film.empty();
  nlohmann::json data{
      {"id", block_name(lesson_, index)},
      {"film", film ? nlohmann::json(site_address(path) + ".mp4") : nlohmann::json(nullptr)},
      {"picture", nullptr},
      {"caption", inline_html(figure.caption)}};
  if (result == nullptr) return data;
  data["picture"] = still_data(path, figure.width, figure.height, figure.alt);
  return data;
}

}  // namespace mjcourse
