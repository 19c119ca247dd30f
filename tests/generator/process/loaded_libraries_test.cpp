#include "process/loaded_libraries.h"

#include <gtest/gtest.h>
#include <link.h>

#include <set>
#include <string>

#include "base/late_library.h"

namespace mjcourse {
namespace {

int add_name(dl_phdr_info* info, std::size_t, void* into) {
  const std::string path = info->dlpi_name;
  static_cast<std::set<std::string>*>(into)->insert(path.substr(path.rfind('/') + 1));
  return 0;
}

// Of the libraries that this process has, as the linker calls them.
std::set<std::string> names_of_loaded() {
  std::set<std::string> names;
  dl_iterate_phdr(add_name, &names);
  std::erase_if(names, [](const std::string& name) {
    return name.empty() || name.starts_with("linux-vdso");
  });
  return names;
}

// That others give another hash, tests/store/dependencies.mjs sees.
TEST(LoadedLibraries, AreAHash) {
  EXPECT_EQ(loaded_libraries().size(), 64);
}

TEST(LoadedLibraries, AreThoseThatAreLoadedLateAsWell) {
  const std::set<std::string> before = names_of_loaded();
  const auto& builds = library_builds();
  EXPECT_EQ(names_of_loaded(), before);
  ASSERT_NE(late_function(kOffscreenGraphics, "OSMesaMakeCurrent"), nullptr);
  ASSERT_NE(late_function(kScriptEngine, "JSEvaluateScript"), nullptr);
  std::set<std::string> named;
  for (const auto& [name, build] : builds) {
    named.insert(name);
    EXPECT_GE(build.size(), 16) << name;
  }
  EXPECT_EQ(named, names_of_loaded());
  EXPECT_GT(named.size(), before.size());
}

}  // namespace
}  // namespace mjcourse
