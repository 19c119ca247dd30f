#include "evaluate/setting.h"

#include <stdexcept>
#include <tl/expected.hpp>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {

std::string script_bundle(const Files& assets, const std::string& name) {
  tl::expected<std::string, std::string> bytes = assets.read("script/" + name + ".js");
  if (!bytes) throw std::runtime_error("the site's assets are not built: " + bytes.error());
  return *std::move(bytes);
}

Setting::Setting(const Course& course, std::filesystem::path root, const Files& assets,
                 std::filesystem::path helper)
    : course_(course),
      root_(std::move(root)),
      assets_(assets),
      helper_(std::move(helper)),
      shown_(shown_programs(course)) {}

const std::optional<Compiler>& Setting::compiler() const {
  const std::lock_guard lock(mutex_);
  if (!compiler_) compiler_ = Compiler::find(helper_);
  return *compiler_;
}

const Setting::Script& Setting::load(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  Script& script = scripts_[name];
  if (script.hash.empty()) {
    script.bytes = script_bundle(assets_, name);
    script.hash = sha256(script.bytes);
  }
  return script;
}

const std::string& Setting::script(const std::string& name) const {
  return load(name).bytes;
}

std::string Setting::script_hash(const std::string& name) const {
  return load(name).hash;
}

}  // namespace mjcourse
