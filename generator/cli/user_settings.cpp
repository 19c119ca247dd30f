#include "cli/user_settings.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/files.h"
#include "lesson/json/yaml_map.h"
#include "lesson/syntax/is_text.h"
#include "lesson/syntax/reading.h"
#include "remote/server.h"

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
  if (const auto server = server_at(store.text); !store.text.empty() && !server) {
    reading.error(kId, store.span(), "no store is there: " + server.error(),
                  "an address such as https://store.example/course");
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
  if (file.empty() || !fs::is_regular_file(file, none)) return {};
  const auto bytes = read_file(file);
  if (!bytes) return {};
  Diagnostics found;
  if (!is_text(file.string(), *bytes, found)) {
    std::ranges::move(found, std::back_inserter(diagnostics));
    return {};
  }
  const SourceText source(file.string(), *bytes);
  Reading reading(source, found);
  UserSettings settings = read_settings(source, reading);
  if (found.empty()) return settings;
  std::ranges::move(found, std::back_inserter(diagnostics));
  return {};
}

}  // namespace mjcourse
