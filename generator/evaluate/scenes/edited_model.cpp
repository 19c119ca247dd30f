#include "evaluate/scenes/edited_model.h"

#include <string>

#include "physics/model_files.h"

namespace mjcourse {
namespace {

// `base`, which has no place of its own, with `inserted` at `at`. What is wrong with the rest came
// of that, so it is blamed on its first byte.
LocatedText insert(const std::string& base, std::size_t at, const LocatedText& inserted) {
  LocatedText whole;
  whole.text = base.substr(0, at) + inserted.text + "\n" + base.substr(at);
  const std::size_t first = inserted.span().begin;
  whole.offsets.append_still(at, first);
  whole.offsets.append(inserted.offsets, 0, inserted.text.size() + 1);
  whole.offsets.append_still(whole.text.size() + 1 - whole.offsets.size(), first);
  return whole;
}

}  // namespace

std::optional<LocatedText> edited_model(const LabContext& context, const Lab::Goal& goal) {
  if (goal.solution_insert.text.empty()) return goal.solution_model;
  const LocatedText& model = context.lab().model;
  const bool is_mjcf = model.text.starts_with('<');
  const std::string base =
      is_mjcf ? model.text
              : read_again(context.worker_context().files(), "models/" + model.text + ".xml");
  const auto refuse = [&](const LocatedText& text, const std::string& message,
                          const std::string& cure) {
    context.error("E-lab-goal", text.span(), message, cure);
    return std::nullopt;
  };
  if (const std::string file = file_named_in(base); !file.empty()) {
    return refuse(goal.solution_insert, "the lab's model names files, as " + file,
                  "write the whole solution as a \"model\" of the course");
  }
  const std::string& before = goal.solution_before.text;
  const std::size_t at = base.find(before);
  if (at == base.npos) {
    return refuse(goal.solution_before, "this text is not in the lab's model",
                  "copy it from there: what is inserted goes before it");
  }
  if (base.find(before, at + 1) != base.npos) {
    return refuse(goal.solution_before, "this text is in the lab's model more than once",
                  "write so much of it that it is there once");
  }
  return insert(base, at, goal.solution_insert);
}

}  // namespace mjcourse
