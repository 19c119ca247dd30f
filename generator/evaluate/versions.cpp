#include "evaluate/versions.h"

#include <mujoco/mujoco.h>

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

// "38261129" of "assets/engine-38261129.wasm", which the manifest names.
std::string engine_hash(const Files& assets) {
  const auto manifest = assets.read("manifest.json");
  if (!manifest) return "";
  const std::string path = nlohmann::json::parse(*manifest).value("engine.wasm", "");
  const std::size_t begin = path.rfind('-') + 1;
  return path.substr(begin, path.rfind('.') - begin);
}

std::string katex_version(const Files& assets) {
  const auto versions = assets.read("versions.json");
  return versions ? nlohmann::json::parse(*versions).value("katex", "") : "";
}

}  // namespace

Versions known_versions(const Files& assets) {
  return {MJCOURSE_VERSION, mj_versionString(), "", katex_version(assets), engine_hash(assets)};
}

}  // namespace mjcourse
