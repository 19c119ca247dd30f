#include "evaluate/setting.h"

#include <utility>

namespace mjcourse {

Setting::Setting(const Course& course, std::filesystem::path root, const Files& assets,
                 std::filesystem::path helper, std::optional<std::filesystem::path> prepared,
                 std::shared_ptr<KnownScripts> scripts)
    : course_(course),
      root_(std::move(root)),
      assets_(assets),
      helper_(std::move(helper)),
      prepared_(std::move(prepared)),
      scripts_(std::move(scripts)),
      shown_(shown_programs(course)) {}

const std::optional<Compiler>& Setting::compiler() const {
  const std::lock_guard lock(mutex_);
  if (!compiler_) compiler_ = Compiler::find(include_folders(), prepared_);
  return *compiler_;
}

const std::string& Setting::script(const std::string& name) const {
  return scripts_->load(assets_, name).bytes;
}

std::string Setting::script_hash(const std::string& name) const {
  return scripts_->load(assets_, name).hash;
}

}  // namespace mjcourse
