#include "evaluate/explain.h"

#include <optional>
#include <utility>

#include "base/parallel.h"
#include "evaluate/plan.h"
#include "evaluate/publish.h"
#include "evaluate/task_store.h"

namespace mjcourse {
namespace {

class Explainer {
 public:
  Explainer(const Course& course, const EvaluationSettings& settings)
      : run_context_(course, settings.root, settings.assets, settings.helper, settings.prepared,
                     settings.script_bundles, settings.without_landlock, settings.page),
        fingerprints_(settings.root),
        task_store_(*settings.store, settings.root, fingerprints_),
        tasks_(plan_tasks(course)),
        records_(tasks_.size()),
        before_(tasks_.size()) {}

  std::vector<Explanation> run(bool puts_lists) {
    look(false, puts_lists);
    publish(tasks_, records_, run_context_.reports(), fingerprints_);
    look(true, puts_lists);
    std::vector<Explanation> all;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (!records_[i].recipe.empty()) all.push_back(explain(i));
    }
    return all;
  }

 private:
  // A store behind a net answers many at once.
  void look(bool quoting, bool puts_lists) {
    std::vector<std::optional<WorkerContext>> contexts(task_store_.at_once());
    for_each_index(tasks_.size(), contexts.size(), [&](std::size_t i, std::size_t thread) {
      Task& task = *tasks_[i];
      TaskRecord& record = records_[i];
      if (task.quotes() != quoting) return;
      if (!contexts[thread]) contexts[thread].emplace(run_context_);
      if (!task.prepare(*contexts[thread], record.finding)) return;
      record.recipe = task.recipe(run_context_);
      before_[i] = task_store_.last(task);
      const bool is_put = task_store_.find(task, record) && record.origin.is_made_here();
      if (is_put && puts_lists) task_store_.put_list(record);
    });
  }

  Explanation explain(std::size_t index) {
    const Task& task = *tasks_[index];
    const TaskRecord& record = records_[index];
    Explanation explanation{task.what(),
                            task.place(),
                            record.reused,
                            record.result,
                            record.reused && record.origin.is_made_here(),
                            record.recipe,
                            std::move(before_[index])};
    Dependencies& now = explanation.now;
    if (record.reused) {
      const Dependencies traced = task_store_.one_by_one(record.traced);
      now.insert(now.end(), traced.begin(), traced.end());
      return explanation;
    }
    // What it looked at the last time, as that is now.
    for (std::size_t i = record.recipe.size(); i < explanation.before.size(); ++i) {
      now.push_back(task_store_.now(explanation.before[i].name));
    }
    return explanation;
  }

  RunContext run_context_;
  Fingerprints fingerprints_;
  TaskStore task_store_;
  Tasks tasks_;
  std::vector<TaskRecord> records_;
  std::vector<Dependencies> before_;  // of each task
};

}  // namespace

std::vector<Explanation> explain_course(const Course& course, const EvaluationSettings& settings,
                                        bool puts_lists) {
  return Explainer(course, settings).run(puts_lists);
}

}  // namespace mjcourse
