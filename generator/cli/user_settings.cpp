#include "cli/user_settings.h"

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "base/files.h"
#include "cli/open_store.h"
#include "lesson/json/yaml_map.h"
#include "lesson/syntax/is_text.h"
#include "lesson/syntax/reading.h"
#include "remote/signature.h"
#include "remote/store_address.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kId = "E-user-config";

fs::path settings_file() {
  const auto folder = [](const char* name) -> fs::path {
    const char* const value = std::getenv(name);
    return value == nullptr || *value != '/' ? "" : value;
  };
  fs::path settings = folder("XDG_CONFIG_HOME");
  if (settings.empty() && !folder("HOME").empty()) settings = folder("HOME") / ".config";
  return settings.empty() ? settings : settings / "mjcourse" / "config.yaml";
}

UserSettings read_settings(const SourceText& source, Reading& reading) {
  UserSettings settings;
  const LocatedText text = located(source, {0, source.text().size()});
  const auto yaml = parse_yaml(text, "settings file", kId, reading);
  if (!yaml || yaml->IsNull()) return settings;  // an empty file sets nothing
  YamlMap map(*yaml, "settings file", kId, text, reading);
  const LocatedText store = map.string("store");
  settings.store = store.text;
  settings.store_read_only = map.boolean("store-read-only", false);
  const std::vector<LocatedText> keys = map.strings("store-trusted-keys");
  map.finish();
  const bool is_address = !store.text.empty() && store.text != kNoServer;
  if (const auto address = read_store_address(store.text); is_address && !address) {
    reading.error(kId, store.span(), address.error(), "write it as https://store.example/course");
  }
  for (const LocatedText& key : keys) {
    settings.trusted_keys.push_back(key.text);
    if (is_public_key(key.text)) continue;
    reading.error(kId, key.span(), "this is no public key, which has 64 hexadecimal digits",
                  "copy it from what `mjcourse store key` said when it made the key");
  }
  return settings;
}

}  // namespace

UserSettings user_settings(Diagnostics& diagnostics) {
  const fs::path file = settings_file();
  std::error_code none;
  if (file.empty() || !fs::exists(file, none)) return {};
  const auto bytes = read_file(fs::is_regular_file(file, none) ? file : fs::path());
  if (!bytes) {
    diagnostics.push_back(error_at({file.string(), 0, 0, 1, ""}, kId,
                                   "the settings file cannot be read", "make it a readable file"));
    return {};
  }
  Diagnostics found;
  UserSettings settings;
  if (is_text(file.string(), *bytes, found)) {
    const SourceText source(file.string(), *bytes);
    Reading reading(source, found);
    settings = read_settings(source, reading);
  }
  if (found.empty()) return settings;
  for (Diagnostic& diagnostic : found) {
    // What the file holds is not shown: it may be a password.
    diagnostic.message = without_userinfo(std::move(diagnostic.message));
    diagnostic.place.column = 0;
    diagnostic.place.excerpt.clear();
    diagnostics.push_back(std::move(diagnostic));
  }
  return {};
}

}  // namespace mjcourse
