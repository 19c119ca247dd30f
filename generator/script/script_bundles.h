// ScriptBundles: reads each script bundle once, and shares it between evaluations.
// Tested by tests/generator/session/live_session_test.cpp.
#pragma once

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>

#include "base/files.h"

namespace mjcourse {

// The installation lacks what the site's build makes.
class MissingAssets : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class ScriptBundles {
 public:
  struct Script {
    std::string bytes, hash;
  };
  // The bundle script/NAME.js of `assets`, always the same ones; from any thread. Throws
  // MissingAssets.
  const Script& load(const Files& assets, const std::string& name);

 private:
  std::mutex mutex_;
  std::map<std::string, Script> scripts_;
};

// Bytes of such a bundle.
std::string script_bundle(const Files& assets, const std::string& name);

}  // namespace mjcourse
