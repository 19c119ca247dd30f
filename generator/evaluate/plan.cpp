#include "evaluate/plan.h"

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include "course/uses.h"
#include "evaluate/block_task.h"
#include "evaluate/commands_task.h"
#include "evaluate/exercise_task.h"
#include "evaluate/formulas_task.h"
#include "evaluate/model_page_task.h"
#include "evaluate/page_task.h"
#include "evaluate/program_task.h"
#include "evaluate/snippets_task.h"

namespace mjcourse {
namespace {

// The files of the programs that are shown whole.
std::set<std::string> whole_programs(const Course& course) {
  std::set<std::string> files;
  for (const Lesson& lesson : course.lessons) {
    for (const Block& block : lesson.blocks) {
      const auto* example = std::get_if<Example>(&block);
      if (example != nullptr && !example->region) files.insert(example->file.text);
    }
  }
  return files;
}

class Planner {
 public:
  explicit Planner(const Course& course) : course_(course), programs_(whole_programs(course)) {}

  Tasks plan() {
    const std::vector<const Lesson*> pages = course_.pages();
    for (std::size_t p = 0; p < pages.size(); ++p) {
      has_formulas_ = has_snippets_ = false;
      for (std::size_t b = 0; b < pages[p]->blocks.size(); ++b) add_block(*pages[p], p, b);
      for (const Link& link : pages[p]->links) add_linked_model(*pages[p], p, link);
    }
    for (std::size_t p = 0; p < pages.size(); ++p) {
      for (const Block& block : pages[p]->blocks) {
        const LocatedText* model = model_of(block);
        if (model != nullptr) add_model_page(*pages[p], p, *model, ModelPageTask::Trouble::known);
      }
    }
    return std::move(tasks_);
  }

 private:
  template <typename Kind, typename... Rest>
  void add(const Lesson& lesson, std::size_t page, Rest&&... rest) {
    tasks_.push_back(std::make_unique<Kind>(lesson, page, std::forward<Rest>(rest)...));
  }

  // What runs natively, and in the page.
  template <typename Kind, typename... Rest>
  void add_programs(const Lesson& lesson, std::size_t page, const Rest&... rest) {
    add<Kind>(lesson, page, rest...);
    tasks_.push_back(std::make_unique<PageTask>(std::make_unique<Kind>(lesson, page, rest...)));
  }

  void add_block(const Lesson& lesson, std::size_t page, std::size_t index) {
    const Block& block = lesson.blocks[index];
    if (const auto* example = std::get_if<Example>(&block)) {
      add_program(lesson, page, index, *example);
    } else if (const auto* exercise = std::get_if<Exercise>(&block)) {
      add_programs<ExerciseTask>(lesson, page, index);
      add_program(lesson, page, index, exercise->program);
    } else if (std::holds_alternative<Math>(block)) {
      if (!std::exchange(has_formulas_, true)) add<FormulasTask>(lesson, page, index);
    } else if (std::holds_alternative<Snippet>(block)) {
      if (!std::exchange(has_snippets_, true)) add_programs<SnippetsTask>(lesson, page, index);
    } else if (std::holds_alternative<Commands>(block)) {
      add<CommandsTask>(lesson, page, index);
    } else if (BlockTask::takes(lesson, index)) {
      add<BlockTask>(lesson, page, index);
    }
  }

  void add_program(const Lesson& lesson, std::size_t page, std::size_t index, Example program) {
    if (program.region) {
      if (!programs_.insert(program.file.text).second) return;
      program.code = {};  // the file's
    }
    add_programs<ProgramTask>(lesson, page, index, program);
  }

  void add_linked_model(const Lesson& lesson, std::size_t page, const Link& link) {
    constexpr std::string_view scheme = "model:";
    if (!link.target.text.starts_with(scheme)) return;
    add_model_page(lesson, page, link.target.part(scheme.size(), link.target.text.size()),
                   ModelPageTask::Trouble::reported);
  }

  void add_model_page(const Lesson& lesson, std::size_t page, const LocatedText& name,
                      ModelPageTask::Trouble trouble) {
    const std::vector<std::string>& known = course_.models;
    // An unknown one is reported elsewhere.
    const bool is_there = std::find(known.begin(), known.end(), name.text) != known.end();
    if (lesson.front.draft || !is_there) return;
    if (models_.insert(name.text).second) add<ModelPageTask>(lesson, page, name, trouble);
  }

  const Course& course_;
  std::set<std::string> programs_, models_;           // that have a task
  bool has_formulas_ = false, has_snippets_ = false;  // the present page
  Tasks tasks_;
};

}  // namespace

Tasks plan_tasks(const Course& course) {
  return Planner(course).plan();
}

}  // namespace mjcourse
