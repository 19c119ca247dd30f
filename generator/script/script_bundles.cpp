#include "script/script_bundles.h"

#include <stdexcept>
#include <tl/expected.hpp>
#include <utility>

#include "base/sha256.h"

namespace mjcourse {

const ScriptBundles::Script& ScriptBundles::load(const Files& assets, const std::string& name) {
  const std::lock_guard lock(mutex_);
  Script& script = scripts_[name];
  if (script.hash.empty()) {
    script.bytes = script_bundle(assets, name);
    script.hash = sha256(script.bytes);
  }
  return script;
}

std::string script_bundle(const Files& assets, const std::string& name) {
  tl::expected<std::string, std::string> bytes = assets.read("script/" + name + ".js");
  if (!bytes) throw MissingAssets("the site's assets are not built: " + bytes.error());
  return *std::move(bytes);
}

}  // namespace mjcourse
