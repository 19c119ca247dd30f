#include "evaluate/explain.h"

#include <utility>

#include "evaluate/archive.h"
#include "evaluate/plan.h"
#include "evaluate/publish.h"

namespace mjcourse {
namespace {

class Explainer {
 public:
  Explainer(const Course& course, const Workplace& workplace)
      : setting_(course, workplace.root, workplace.assets, workplace.helper, workplace.prepared,
                 workplace.known_scripts),
        fingerprints_(workplace.root),
        archive_(*workplace.store, workplace.root, fingerprints_),
        workshop_(setting_),
        tasks_(plan_tasks(course)),
        records_(tasks_.size()) {}

  std::vector<Explanation> run() {
    look(false);
    publish(tasks_, records_, setting_.reports(), fingerprints_);
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
      if (task.quotes() != quoting || !task.prepare(workshop_, record.finding)) continue;
      record.recipe = task.recipe(setting_);
      before_[&task] = archive_.last(task);
      archive_.find(task, record);
    }
  }

  Explanation explain(const Task& task, const TaskRecord& record) {
    Explanation explanation{task.what(), task.place(), record.reused, record.recipe,
                            std::move(before_[&task])};
    Dependencies& now = explanation.now;
    if (record.reused) {
      const Dependencies traced = archive_.one_by_one(record.traced);
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

  Setting setting_;
  Fingerprints fingerprints_;
  Archive archive_;
  Workshop workshop_;
  Tasks tasks_;
  std::vector<TaskRecord> records_;
  std::map<const Task*, Dependencies> before_;
};

}  // namespace

std::vector<Explanation> explain_course(const Course& course, const Workplace& workplace) {
  return Explainer(course, workplace).run();
}

}  // namespace mjcourse
