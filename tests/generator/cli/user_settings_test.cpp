#include "cli/user_settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

struct Found {
  UserSettings settings;
  std::string said;  // with FILE for the file's path
};

Found settings_of(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "mjcourse" / "config.yaml";
  std::filesystem::create_directory(file.parent_path());
  write_file(file, text);
  setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
  Found found;
  Diagnostics diagnostics;
  found.settings = user_settings(diagnostics);
  unsetenv("XDG_CONFIG_HOME");
  found.said = format_for_terminal(diagnostics, TerminalStyle{});
  for (std::size_t at = 0; (at = found.said.find(file.string())) != std::string::npos;) {
    found.said.replace(at, file.string().size(), "FILE");
  }
  return found;
}

TEST(UserSettings, NameAStore) {
  const std::string key(64, 'a');
  const Found found = settings_of(
      "store: https://store.example/course\nstore-read-only: true\n"
      "store-trusted-keys: [" +
      key + "]\n");
  EXPECT_EQ(found.said, "");
  EXPECT_EQ(found.settings.store, "https://store.example/course");
  EXPECT_TRUE(found.settings.store_read_only);
  EXPECT_EQ(found.settings.trusted_keys, std::vector<std::string>{key});
}

TEST(UserSettings, MaySetNothing) {
  EXPECT_EQ(settings_of("").said, "");
  EXPECT_EQ(settings_of("# none\n").settings.store, "");
  setenv("XDG_CONFIG_HOME", "/nowhere", 1);
  Diagnostics none;
  EXPECT_EQ(user_settings(none).store, "");
  EXPECT_TRUE(none.empty());
  unsetenv("XDG_CONFIG_HOME");
}

TEST(UserSettings, SayWhatIsWrongAndThenSetNothing) {
  const Found found = settings_of("stor: x\nstore: store.example\nstore-trusted-keys: [abc]\n");
  EXPECT_EQ(found.settings.store, "");
  EXPECT_EQ(found.said, R"(FILE:1: error: the settings file has no key `stor` [E-user-config]
  cure: did you mean `store`?

FILE:2: error: the address of a shared store begins with http://, https:// or unix:/ [E-user-config]
  cure: write it as https://store.example/course

FILE:3: error: this is no public key, which has 64 hexadecimal digits [E-user-config]
  cure: copy it from what `mjcourse store key` said when it made the key

)");
  EXPECT_EQ(settings_of("store: none\n").said, "");
  EXPECT_EQ(settings_of("store: http://u:hunter2@h/?x\n").said.find("hunter2"), std::string::npos);
  EXPECT_EQ(settings_of("http://u:hunter2@h: x\n").said,
            "FILE:1: error: the settings file has no key `http://…@h` [E-user-config]\n"
            "  cure: known: store, store-read-only, store-trusted-keys\n\n");
  EXPECT_NE(settings_of("store: [").said, "");
  EXPECT_NE(settings_of(std::string("\0", 1)).said, "");
}

}  // namespace
}  // namespace mjcourse
