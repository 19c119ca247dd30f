#include "process/known_package.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

// With an apt-cache that knows `pattern`, and with none where that is empty.
std::string known_where_apt_knows(const std::string& pattern) {
  const TemporaryFolder folder;
  if (!pattern.empty()) {
    const std::filesystem::path apt = folder.path() / "apt-cache";
    write_file(apt, "#!/bin/sh\n[ \"$*\" != 'search --names-only " + pattern + "' ] || echo it\n");
    std::filesystem::permissions(apt, std::filesystem::perms::owner_all);
  }
  const std::string path = std::getenv("PATH");
  setenv("PATH", folder.path().c_str(), 1);
  const std::string found = known_package({"clang-16", "clang-19"});
  setenv("PATH", path.c_str(), 1);
  return found;
}

TEST(KnownPackage, IsTheFirstThatAptKnows) {
  EXPECT_EQ(known_where_apt_knows("^clang-16$"), "clang-16");
  EXPECT_EQ(known_where_apt_knows("^clang-19$"), "clang-19");
}

TEST(KnownPackage, IsTheFirstWhereAptKnowsNone) {
  EXPECT_EQ(known_where_apt_knows("^gcc$"), "clang-16");
  EXPECT_EQ(known_where_apt_knows(""), "clang-16");
}

}  // namespace
}  // namespace mjcourse
