#include "evaluate/evaluate.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "cache/fingerprints.h"
#include "evaluate/api_names.h"
#include "evaluate/api_reference.h"
#include "evaluate/claims/claims.h"
#include "evaluate/commands_task.h"
#include "evaluate/exercise_task.h"
#include "evaluate/gather_diagnostics.h"
#include "evaluate/page_task.h"
#include "evaluate/plan.h"
#include "evaluate/program_task.h"
#include "evaluate/programs/exercise.h"
#include "evaluate/programs/output.h"
#include "evaluate/programs/region.h"
#include "evaluate/publish.h"
#include "evaluate/scheduler.h"
#include "evaluate/snippets_task.h"
#include "evaluate/task_store.h"
#include "evaluate/task_times.h"
#include "evaluate/versions.h"
#include "physics/mujoco_api.h"
#include "process/sandbox.h"

namespace mjcourse {
namespace {

// Hold the outputs that the lesson states against what its example printed.
void compare_outputs(const Lesson& lesson, LessonResults& results, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* output = std::get_if<Output>(&lesson.blocks[i]);
    const auto* example = output != nullptr ? results.get<ExampleResult>(output->example) : nullptr;
    if (example == nullptr) continue;
    if (results.open.contains(output->example)) {
      results.open.insert(i);
      results.of_block[i] = OutputResult{};
      continue;
    }
    if (auto result = evaluate_output(*output, *example, lesson, diagnostics)) {
      results.of_block[i] = *result;
    }
  }
}

// Null where it is another.
const PageTask* page_task(const Task& task) {
  return dynamic_cast<const PageTask*>(&task);
}

template <typename... Kinds>
bool has_any(const Tasks& tasks) {
  return std::any_of(tasks.begin(), tasks.end(), [](const auto& task) {
    return ((dynamic_cast<const Kinds*>(task.get()) != nullptr) || ...);
  });
}

// A region has what its program printed, but not its program's code.
void show_regions(const Lesson& lesson, const std::filesystem::path& root,
                  const ShownPrograms& shown, const std::map<std::string, ExampleResult>& programs,
                  LessonResults& results, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* example = std::get_if<Example>(&lesson.blocks[i]);
    if (example == nullptr || !example->region) continue;
    const std::string& file = example->file.text;
    const auto program = programs.find(file);
    const bool ran = program != programs.end();
    if (!ran && results.open.contains(i)) continue;
    results.of_block.erase(i);
    const Example* whole = shown.at(file).text();
    const auto text = whole != nullptr ? whole->code.text : DiskFiles(root).read(file);
    if (!text) continue;  // reported where the program is run
    const bool may_edit = ran && whole == nullptr && !shown.at(file).contradicts_itself();
    const auto code =
        evaluate_region(*example, SourceText(file, *text), may_edit, lesson, diagnostics);
    if (code && ran) {
      results.of_block[i] = ExampleResult{*code, program->second.output, {},
                                          0,     program->second.files,  program->second.page};
    }
  }
}

// What the run of its solution found belongs to an exercise, too.
void add_solutions(const Lesson& lesson, const std::map<std::string, ExampleResult>& programs,
                   LessonResults& results, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    const auto* exercise = std::get_if<Exercise>(&lesson.blocks[i]);
    if (exercise == nullptr) continue;
    const auto result = results.of_block.find(i);
    const auto solution = programs.find(exercise->program.file.text);
    if (result == results.of_block.end()) continue;
    if (solution == programs.end()) {
      results.of_block.erase(result);
    } else if (!results.open.contains(i)) {
      add_solution(*exercise, solution->second, lesson, std::get<ExerciseResult>(result->second),
                   diagnostics);
    }
  }
}

class Evaluator {
 public:
  Evaluator(const Course& course, const EvaluationSettings& settings, Progress& progress)
      : course_(course),
        settings_(settings),
        progress_(progress),
        run_context_(course, settings.root, settings.assets, settings.helper, settings.prepared,
                     settings.script_bundles, settings.without_landlock, settings.page),
        fingerprints_(settings.root, settings.fingerprint_cache) {
    if (settings.store == nullptr) return;
    task_store_.emplace(*settings.store, settings.root, fingerprints_);
    run_context_.actions().keep_in(task_store_->results());
  }

  Evaluation run(Diagnostics found) {
    evaluation_.lessons.resize(course_.lessons.size());
    if (settings_.shard.is_first()) evaluation_.diagnostics = std::move(found);
    evaluation_.versions = known_versions(settings_.assets);
    Tasks tasks = plan_tasks(course_);
    if (run_context_.page() == nullptr) {
      std::erase_if(tasks, [](const auto& task) { return page_task(*task) != nullptr; });
    }
    evaluation_.all_tasks = tasks.size();
    const bool whole = settings_.shard.is_whole();
    TaskTimes times(whole && !settings_.notes_times ? nullptr : settings_.store, course_.title);
    if (!whole) take_share(tasks, times);
    evaluation_.tasks = tasks.size();
    if (run_context_.page() != nullptr) evaluation_.versions.page = run_context_.page()->version();
    const bool compiles = has_any<ProgramTask, SnippetsTask>(tasks) && run_context_.compiler();
    if (compiles) evaluation_.versions.compiler = run_context_.compiler()->version();
    if ((compiles || has_any<CommandsTask>(tasks)) && !run_context_.why_nothing_runs()) {
      evaluation_.sandbox = sandbox_level().text();
    }
    Scheduler scheduler(run_context_, task_store_ ? &*task_store_ : nullptr, progress_,
                        settings_.threads, effort(), settings_.worker);
    TaskRecords records = scheduler.run(tasks, settings_.first, [&](const TaskRecords& done) {
      publish(tasks, done, run_context_.reports(), fingerprints_);
    });
    if (settings_.notes_times) note(tasks, records, times);
    gather(tasks, std::move(records));
    const std::vector<TaskTime>& headers = scheduler.header_times();
    evaluation_.times.insert(evaluation_.times.end(), headers.begin(), headers.end());
    for (std::size_t i = 0; i < course_.lessons.size(); ++i) finish(i);
    const auto results_of = [&](const Lesson& page) -> const auto& {
      return evaluation_.results_of(page);
    };
    if (const auto& api = installed_mujoco_api()) evaluation_.api_names = api_names(*api);
    Diagnostics of_others;
    evaluation_.api =
        evaluate_api(course_, results_of, installed_mujoco_api, settings_.threads,
                     settings_.shard.is_first() ? evaluation_.diagnostics : of_others);
    ClaimSources sources(settings_.root, course_.models, run_context_.include_folders(),
                         fingerprints_);
    make_claims(course_, sources, programs_, settings_.threads, evaluation_);
    if (!whole) forget_open_claims();
    return std::move(evaluation_);
  }

 private:
  Effort effort() const {
    if (settings_.stand_in) return Effort::looks;
    return settings_.natively ? Effort::natively : Effort::all;
  }

  void take_share(Tasks& tasks, const TaskTimes& times) {
    const Share share(tasks, settings_.shard, times, run_context_);
    evaluation_.open = true;
    evaluation_.division = share.division();
    for (const Lesson* page : course_.pages()) {
      evaluation_.results_of(*page).open = share.blocks_of_others(*page);
    }
    // An author who misspells one gets the same suggestion from all shards.
    for (const std::string& name : share.programs_of_others()) {
      run_context_.reports().add(name, nullptr);
    }
  }

  void forget_open_claims() {
    for (const Lesson* page : course_.pages()) {
      LessonResults& results = evaluation_.results_of(*page);
      std::erase_if(results.claims,
                    [&](const Claim& claim) { return results.open.contains(claim.block); });
      results.tally = tally_of(results.claims);
    }
  }

  static void note(const Tasks& tasks, const TaskRecords& records, TaskTimes& times) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      times.note(*tasks[i], records[i].recipe, records[i].finding.work);
    }
    times.write();
  }

  // Each finding goes under its blocks.
  void gather(const Tasks& tasks, TaskRecords records) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const Task& task = *tasks[i];
      Finding& finding = records[i].finding;
      if (records[i].open) stand_in(task, finding);
      if (!records[i].open) {
        evaluation_.times.push_back({task.what(), records[i].thread, records[i].begin,
                                     records[i].seconds, records[i].reused, records[i].in_page});
      }
      gather_diagnostics(std::move(finding.diagnostics), evaluation_.diagnostics);
      if (finding.model_page) evaluation_.models.push_back(*std::move(finding.model_page));
      LessonResults& results = task.page() < evaluation_.lessons.size()
                                   ? evaluation_.lessons[task.page()]
                                   : evaluation_.glossary;
      results.seconds.merge(finding.seconds);
      if (const PageTask* page = page_task(task)) {
        evaluation_.open_in_page += records[i].open ? 1 : 0;
        take_pages(*page, records[i].open, finding, results);
        continue;
      }
      if (records[i].open) {
        for (const std::size_t block : task.blocks()) results.open.insert(block);
      }
      if (const auto* program = dynamic_cast<const ProgramTask*>(&task)) take(*program, finding);
      results.of_block.merge(finding.results);
    }
    std::sort(evaluation_.models.begin(), evaluation_.models.end(),
              [](const ModelPage& a, const ModelPage& b) { return a.name < b.name; });
  }

  // An exercise has a result of its own beside that of its solution.
  void take(const ProgramTask& task, Finding& finding) {
    const auto found = finding.results.find(task.block());
    if (found == finding.results.end()) return;
    if (const auto* result = std::get_if<ExampleResult>(&found->second)) {
      programs_[task.program().file.text] = *result;
    }
    if (std::holds_alternative<Exercise>(task.lesson().blocks[task.block()])) {
      finding.results.erase(found);
    }
  }

  // What the programs of a task are in the page belongs to the results that they have natively.
  void take_pages(const PageTask& task, bool open, const Finding& finding, LessonResults& results) {
    const auto* program = dynamic_cast<const ProgramTask*>(&task.native());
    const bool is_exercise = dynamic_cast<const ExerciseTask*>(&task.native()) != nullptr;
    for (const std::size_t block : task.blocks()) {
      const auto page = finding.pages.find(block);
      const bool is_known = page != finding.pages.end();
      const auto result = results.of_block.find(block);
      const bool has_result = result != results.of_block.end();
      if (is_known && program != nullptr) {
        const auto ran = programs_.find(program->program().file.text);
        if (ran != programs_.end()) ran->second.page = page->second;
      }
      if (!has_result) continue;
      if (is_exercise && is_known) {
        std::get<ExerciseResult>(result->second).why_not = page->second.why_not;
      } else if (is_exercise && !open) {
        results.of_block.erase(result);  // its starter or a mistake is another there
      } else if (auto* ran = std::get_if<ExampleResult>(&result->second); ran && is_known) {
        ran->page = page->second;
      }
    }
  }

  void stand_in(const Task& task, Finding& finding) {
    evaluation_.open = true;
    if (!settings_.stand_in) return;
    const PageTask* page = page_task(task);
    for (const std::size_t block : task.blocks()) {
      auto result = settings_.stand_in(task.lesson(), block);
      if (!result) continue;
      if (page == nullptr) {
        finding.results[block] = *std::move(result);
      } else if (auto known = page->known_of(*result)) {
        finding.pages[block] = *std::move(known);
      }
    }
  }

  void finish(std::size_t index) {
    const Lesson& lesson = course_.lessons[index];
    LessonResults& results = evaluation_.lessons[index];
    show_regions(lesson, settings_.root, run_context_.shown(), programs_, results,
                 evaluation_.diagnostics);
    add_solutions(lesson, programs_, results, evaluation_.diagnostics);
    compare_outputs(lesson, results, evaluation_.diagnostics);
  }

  const Course& course_;
  const EvaluationSettings& settings_;
  Progress& progress_;
  RunContext run_context_;
  Fingerprints fingerprints_;
  std::optional<TaskStore> task_store_;
  std::map<std::string, ExampleResult> programs_;  // by their files
  Evaluation evaluation_;
};

}  // namespace

Evaluation evaluate(const Course& course, const EvaluationSettings& settings, Progress& progress,
                    Diagnostics found) {
  return Evaluator(course, settings, progress).run(std::move(found));
}

}  // namespace mjcourse
