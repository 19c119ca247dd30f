// What a user has set once for all commands: ${XDG_CONFIG_HOME:-~/.config}/mjcourse/config.yaml.
// Tested by tests/generator/cli/user_settings_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "report/diagnostic.h"

namespace mjcourse {

struct UserSettings {
  std::string store;             // the address of a shared store; empty for none
  bool store_read_only = false;  // put nothing there
  std::vector<std::string> trusted_keys;
};

// Where there is no such file, or one with mistakes, nothing is set.
UserSettings user_settings(Diagnostics& diagnostics);

}  // namespace mjcourse
