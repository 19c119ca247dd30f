#include "evaluate/publish.h"

#include <variant>

#include "base/sha256.h"
#include "evaluate/program_task.h"

namespace mjcourse {

void publish(const Tasks& tasks, const TaskRecords& records, Reports& reports,
             Fingerprints& fingerprints) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const auto* task = dynamic_cast<const ProgramTask*>(tasks[i].get());
    if (task == nullptr) continue;
    const auto& results = records[i].finding.results;
    const auto found = results.find(task->block());
    const auto* result = found == results.end() ? nullptr : &std::get<ExampleResult>(found->second);
    const std::string name = task->program().name();
    reports.add(name, result);
    // A lesson that quotes a program may say where it is.
    fingerprints.set(
        program_dependency(name),
        records[i].open ? "not known yet"
        : result == nullptr
            ? "failed"
            : Sha256().add(task->program().file.text).add(fingerprint_of(result->records)).hex());
  }
}

}  // namespace mjcourse
