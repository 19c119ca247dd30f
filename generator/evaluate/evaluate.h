// Enter evaluating here: from a course that was read to what is true of it.
//
// Steps: the course is planned as tasks (plan.h). A scheduler runs them on all cores, and takes
// from the store what was found out before (scheduler.h). What the tasks found is gathered under
// the blocks. Outputs are held against what the programs printed. All of it becomes claims
// (claims.h). What always holds: the results and the diagnostics depend neither on the number of
// threads nor on the store.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/parallel.h"
#include "base/store.h"
#include "cache/fingerprints.h"
#include "course/course.h"
#include "evaluate/progress.h"
#include "evaluate/shard.h"
#include "evaluate/worker.h"
#include "findings/evaluation.h"
#include "report/diagnostic.h"
#include "script/script_bundles.h"

namespace mjcourse {

// What to show of a block that is not known yet; nothing where there is nothing.
using StandIn = std::function<std::optional<Result>(const Lesson& lesson, std::size_t block)>;

struct EvaluationSettings {
  std::filesystem::path root;  // the course's folder
  const Files& assets;         // what the site's build made
  Store* store = nullptr;      // may be null: then all is worked out
  std::size_t threads = core_count();
  std::filesystem::path helper = {};  // has the helper header for a course without one
  // Where what programs share is kept (warm_objects.h); without it nothing is.
  std::optional<std::filesystem::path> prepared = {};
  // Of files and scripts that were looked at before, for a caller that evaluates again and again.
  std::shared_ptr<FingerprintCache> fingerprint_cache = std::make_shared<FingerprintCache>();
  std::shared_ptr<ScriptBundles> script_bundles = std::make_shared<ScriptBundles>();
  Shard shard = {};  // what is worked out of the course
  // For those who plan to work on all of it, note what each task took.
  bool notes_times = false;
  // Given, nothing is worked out: what the store does not have stays open, with a stand-in.
  StandIn stand_in = {};
  // What programs are in the page is not worked out: what the store does not have of it stays open.
  bool natively = false;
  Blocks first = {};              // what somebody waits for: begun before all else
  bool without_landlock = false;  // run programs even where the kernel has none
  // For what is worked on in processes of their own; without it, nothing is.
  std::optional<WorkerProgram> worker = {};
  // What a page compiles programs with (page_toolchain.h); without it, programs run natively alone.
  std::filesystem::path page = {};
};

// Throws Cancelled when the caller's work is cancelled. The diagnostics begin with what reading the
// course `found` wrong.
Evaluation evaluate(const Course& course, const EvaluationSettings& settings, Progress& progress,
                    Diagnostics found = {});

}  // namespace mjcourse
