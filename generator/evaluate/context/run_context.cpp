#include "evaluate/context/run_context.h"

#include <utility>

#include "process/sandbox.h"

namespace mjcourse {

RunContext::RunContext(const Course& course, std::filesystem::path root, const Files& assets,
                       std::filesystem::path helper, std::optional<std::filesystem::path> prepared,
                       std::shared_ptr<ScriptBundles> scripts, bool without_landlock,
                       const std::filesystem::path& page)
    : course_(course),
      root_(std::move(root)),
      assets_(assets),
      helper_(std::move(helper)),
      prepared_(std::move(prepared)),
      scripts_(std::move(scripts)),
      without_landlock_(without_landlock),
      page_(PageToolchain::find(page)),
      shown_(shown_programs(course)),
      actions_(root_) {}

const std::optional<Compiler>& RunContext::compiler() const {
  const std::lock_guard lock(mutex_);
  if (!compiler_) compiler_ = Compiler::find(include_folders(), prepared_);
  return *compiler_;
}

Diagnostic no_compiler() {
  return error_at({}, "E-example-compiler", "no C++ compiler was found",
                  "install " + compiler_package());
}

std::optional<Diagnostic> RunContext::why_nothing_runs() const {
  if (without_landlock_ || sandbox_level().landlock > 0) return std::nullopt;
  return error_at(
      {}, "E-sandbox-landlock",
      "nothing of a course is run here: this kernel has no Landlock, which keeps programs "
      "from your files",
      "a kernel from 5.13 on that has Landlock turned on (`lsm=landlock,...`); or, for a "
      "course whose every program you trust, --unsafe-without-landlock");
}

const std::string& RunContext::script(const std::string& name) const {
  return scripts_->load(assets_, name).bytes;
}

std::string RunContext::script_hash(const std::string& name) const {
  return scripts_->load(assets_, name).hash;
}

}  // namespace mjcourse
