// KnownScripts: bundles that were read, shared by who evaluates again and again.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "base/files.h"

namespace mjcourse {

class KnownScripts {
 public:
  struct Script {
    std::string bytes, hash;
  };
  // The bundle script/NAME.js of `assets`, always the same ones; from any thread. Throws
  // std::runtime_error when the assets were not built.
  const Script& load(const Files& assets, const std::string& name);

 private:
  std::mutex mutex_;
  std::map<std::string, Script> scripts_;
};

// Bytes of such a bundle.
std::string script_bundle(const Files& assets, const std::string& name);

}  // namespace mjcourse
