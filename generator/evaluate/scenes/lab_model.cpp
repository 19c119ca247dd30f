#include "evaluate/scenes/lab_model.h"

#include "physics/model_files.h"

namespace mjcourse {

std::optional<LabModel> find_lab_model(const LabContext& context) {
  const LocatedText& named = context.lab().model;
  const auto refuse = [&](const std::string& message, const std::string& cure) {
    context.error("E-lab-files", named.span(), message, cure);
    return std::nullopt;
  };
  if (named.text.starts_with('<')) {
    const std::string file = file_named_in(named.text);
    if (file.empty()) return LabModel{"model.xml", {{"model.xml", named.text}}, {}};
    return refuse("a model inside a lesson cannot name files; this one names " + file,
                  "put the model into a file of its own, models/NAME.xml");
  }
  const std::filesystem::path& root = context.worker_context().root();
  const tl::expected<ModelSources, std::string> sources =
      find_model_sources(root, "models/" + named.text + ".xml");
  if (!sources) return refuse(sources.error(), "rename a file, or leave one out");
  LabModel model{sources->main, {}, {sources->assets.begin(), sources->assets.end()}};
  for (const auto& [name, text_path] : sources->texts) {
    auto text = read_beneath(root, text_path);
    if (!text) throw LostFile(text.error());
    model.texts[name] = *std::move(text);
  }
  return model;
}

}  // namespace mjcourse
