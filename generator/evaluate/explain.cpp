#include "evaluate/explain.h"

#include <utility>

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
        worker_context_(run_context_),
        tasks_(plan_tasks(course)),
        records_(tasks_.size()) {}

  std::vector<Explanation> run() {
    look(false);
    publish(tasks_, records_, run_context_.reports(), fingerprints_);
    look(true);
    std::vector<Explanation> all;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (!records_[i].recipe.empty()) all.push_back(explain(*tasks_[i], records_[i]));
    }
    return all;
  }

 private:
  void look(bool quoting) {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      Task& task = *tasks_[i];
      TaskRecord& record = records_[i];
      if (task.quotes() != quoting || !task.prepare(worker_context_, record.finding)) continue;
      record.recipe = task.recipe(run_context_);
      before_[&task] = task_store_.last(task);
      task_store_.find(task, record);
    }
  }

  Explanation explain(const Task& task, const TaskRecord& record) {
    Explanation explanation{task.what(), task.place(), record.reused, record.recipe,
                            std::move(before_[&task])};
    Dependencies& now = explanation.now;
    if (record.reused) {
      const Dependencies traced = task_store_.one_by_one(record.traced);
      now.insert(now.end(), traced.begin(), traced.end());
      return explanation;
    }
    // What it looked at the last time, as that is now.
    for (std::size_t i = record.recipe.size(); i < explanation.before.size(); ++i) {
      const std::string& name = explanation.before[i].name;
      now.push_back({name, fingerprints_.of(name)});
    }
    return explanation;
  }

  RunContext run_context_;
  Fingerprints fingerprints_;
  TaskStore task_store_;
  WorkerContext worker_context_;
  Tasks tasks_;
  std::vector<TaskRecord> records_;
  std::map<const Task*, Dependencies> before_;
};

}  // namespace

std::vector<Explanation> explain_course(const Course& course, const EvaluationSettings& settings) {
  return Explainer(course, settings).run();
}

}  // namespace mjcourse
