// The data that the template of a figure is fed with; its own comment describes it.
#include "page/lesson_pictures.h"
#include "page/page_writer.h"

namespace mjcourse {

nlohmann::json PageWriter::data_of(const Figure& figure, std::size_t index) {
  ++figures_;
  const auto* result = results_.get<FigureResult>(index);
  const std::string path = "../" + figure_path(lesson_, figures_);
  const bool film = result != nullptr && !result->film.empty();
  return {{"id", "figure-" + std::to_string(figures_)},
          {"film", film ? nlohmann::json(path + ".mp4") : nlohmann::json(nullptr)},
          {"picture",
           {{"webp", path + ".webp"},
            {"png", path + ".png"},
            {"width", figure.width},
            {"height", figure.height},
            {"alt", figure.alt}}},
          {"caption", inline_html(figure.caption)}};
}

}  // namespace mjcourse
