// RunContext: what all threads that evaluate a course have in common.
// Tested by tests/generator/evaluate/context/worker_context_test.cpp.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "actions/action_store.h"
#include "base/files.h"
#include "course/course.h"
#include "evaluate/context/reports.h"
#include "evaluate/context/shown_program.h"
#include "physics/model_cache.h"
#include "script/script_bundles.h"
#include "toolchain/compiler.h"
#include "toolchain/page_toolchain.h"

namespace mjcourse {

class RunContext {
 public:
  // `root` is the course's folder on the disk; `assets` holds script/*.js; `helper` is where the
  // helper header is for a course without one; `prepared` is where what programs share is kept, and
  // without it nothing is. Programs run `without_landlock` only where that is true. `page` has
  // what a page compiles programs with (page_toolchain.h), or is empty. All must outlive this.
  RunContext(const Course& course, std::filesystem::path root, const Files& assets,
             std::filesystem::path helper = {}, std::optional<std::filesystem::path> prepared = {},
             std::shared_ptr<ScriptBundles> scripts = std::make_shared<ScriptBundles>(),
             bool without_landlock = false, const std::filesystem::path& page = {});

  const Course& course() const { return course_; }
  const std::filesystem::path& root() const { return root_; }
  // Where programs find headers of the course, or of the tool.
  IncludeFolders include_folders() const { return include_folders_of(root_ / "examples", helper_); }
  const ShownPrograms& shown() const { return shown_; }

  // Nothing when none is installed. Looked for when first asked for.
  const std::optional<Compiler>& compiler() const;

  // With which programs are run a second time; null where there is none.
  const PageToolchain* page() const { return page_.get(); }

  // Why no program, and no command, of the course may be run or compiled here; without a place.
  std::optional<Diagnostic> why_nothing_runs() const;

  // Shared by all threads.
  ModelCache& models() const { return models_; }
  ActionStore& actions() const { return actions_; }

  // The bundle script/NAME.js; throws std::runtime_error when the assets were not built.
  const std::string& script(const std::string& name) const;
  std::string script_hash(const std::string& name) const;

  // Complete, and changed no more, once all programs were run.
  Reports& reports() { return reports_; }
  const Reports& reports() const { return reports_; }

 private:
  const Course& course_;
  std::filesystem::path root_;
  const Files& assets_;
  std::filesystem::path helper_;
  std::optional<std::filesystem::path> prepared_;
  std::shared_ptr<ScriptBundles> scripts_;
  bool without_landlock_;
  std::unique_ptr<PageToolchain> page_;
  ShownPrograms shown_;
  Reports reports_;
  mutable ModelCache models_;
  mutable ActionStore actions_;
  mutable std::mutex mutex_;  // of what is made when first asked for
  mutable std::optional<std::optional<Compiler>> compiler_;
};

// There is no compiler; without a place.
Diagnostic no_compiler();

}  // namespace mjcourse
