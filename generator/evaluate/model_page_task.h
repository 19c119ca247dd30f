// ModelPageTask: what the page of a model tells.
#pragma once

#include "evaluate/task.h"

namespace mjcourse {

class ModelPageTask : public Task {
 public:
  // The first link to it is `name`, in `lesson`.
  ModelPageTask(const Lesson& lesson, std::size_t page, LocatedText name)
      : Task(lesson, page, 0, "draw the model " + name.text), name_(std::move(name)) {}

  std::vector<std::size_t> blocks() const override { return {}; }
  double effort() const override { return 0.2; }
  Dependencies recipe(const Setting& setting) const override;
  bool work(Workshop& workshop, Finding& finding) override;

 private:
  LocatedText name_;
};

}  // namespace mjcourse
