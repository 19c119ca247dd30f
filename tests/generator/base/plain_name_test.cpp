#include "base/plain_name.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

std::string fault(std::string_view name) {
  const auto found = fault_of_name(name);
  return found ? found->text() : "";
}

TEST(PlainName, HasWhatSystemsAndAddressesHave) {
  for (const char* name : {"1-first-steps", "a.b", "A b", "ünï", "関節", "a'b$c", "@x", "-x", "~",
                           "console", "com", "com10", "a..b"}) {
    EXPECT_EQ(fault(name), "") << name;
  }
}

TEST(PlainName, IsOneStepOfAPath) {
  EXPECT_EQ(fault(""), "`` is no name");
  EXPECT_EQ(fault("."), "`.` is the folder itself");
  EXPECT_EQ(fault(".."), "`..` is the folder above");
  for (const char* name : {"/", "/etc", "a/", "a/..", "..//"}) {
    EXPECT_EQ(fault(name),
              std::string("`") + name + "` has a `/` in it, where the name of a folder ends");
  }
}

TEST(PlainName, IsANameOnWindowsToo) {
  EXPECT_EQ(fault("..\\a"), "`..\\a` has a `\\` in it, which is a `/` on Windows");
  for (const char sign : std::string("<>:\"|?*")) {
    const std::string name = std::string("a") + sign + "b";
    EXPECT_EQ(fault(name),
              "`" + name + "` has a `" + sign + "` in it, which no name on Windows has");
  }
  EXPECT_EQ(fault("a."), "`a.` ends with a dot, which Windows leaves out");
  EXPECT_EQ(fault("a "), "`a ` ends with a blank, which Windows leaves out");
  for (const char* name :
       {"con", "NUL", "Aux.html", "prn .txt", "com1", "LPT9.a.b", "com²", "conin$"}) {
    EXPECT_EQ(fault(name), std::string("`") + name + "` is a device on Windows");
  }
}

TEST(PlainName, IsShownAsItIs) {
  EXPECT_EQ(fault("a\nb"), "`a\\nb` has a control character in it");
  EXPECT_EQ(fault("\x7f"), "`\\x7f` has a control character in it");
  EXPECT_EQ(fault(std::string_view("a\0b", 3)), "`a\\x00b` has a control character in it");
  EXPECT_EQ(fault("a\u202Eb"), "`a\\u202eb` has a control character in it");
  EXPECT_EQ(fault("a\xff"), "`a\uFFFD` is not UTF-8");
  EXPECT_EQ(fault(".a"), "`.a` begins with a dot, so it is hidden");
  for (const char* name : {".git", ".GIT", "GIT~1"}) {
    EXPECT_EQ(fault_of_path(name, Hidden::is_allowed)->text(),
              std::string("`") + name + "` is where git keeps what is its own");
  }
  EXPECT_FALSE(fault_of_path(".deep/.a", Hidden::is_allowed));
  EXPECT_EQ(fault_of_path(".deep/..\\a", Hidden::is_allowed)->text(),
            "`..\\a` has a `\\` in it, which is a `/` on Windows");
  EXPECT_EQ(fault_of_path(".deep/../a", Hidden::is_allowed)->text(), "`..` is the folder above");
}

TEST(PlainName, HasRoomForAnEnding) {
  EXPECT_EQ(fault(std::string(kLongestName, 'a')), "");
  const std::string name(kLongestName + 1, 'a');
  EXPECT_EQ(fault(name), "`" + name + "` has more than 230 bytes");
}

TEST(PlainName, MakesAPathWithOthers) {
  EXPECT_FALSE(fault_of_path("arm/scene.xml"));
  for (const auto& [path, part] : std::initializer_list<std::pair<const char*, const char*>>{
           {"a/../b", ".."}, {"a//b", ""}, {"/a", ""}, {"a/", ""}, {"a/nul/b", "nul"}, {"", ""}}) {
    ASSERT_TRUE(fault_of_path(path)) << path;
    EXPECT_EQ(fault_of_path(path)->name, part) << path;
  }
}

}  // namespace
}  // namespace mjcourse
