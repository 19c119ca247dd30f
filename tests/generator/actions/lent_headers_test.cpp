#include "actions/lent_headers.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(LentHeaders, AreThoseThatAProgramIncludesAndNoOthers) {
  const TemporaryFolder folder;
  const fs::path from = folder.path() / "examples", to = folder.path() / "lent/examples";
  fs::create_directories(from / "parts");
  write_file(from / "plan.hpp", "#include \"parts/a.hpp\"\n#include \"plan.hpp\"\n");
  write_file(from / "parts/a.hpp", "#include \"b.hpp\"\n#include <vector>\n");
  write_file(from / "parts/b.hpp", "");
  write_file(from / "solution.cpp", "secret");
  write_file(folder.path() / "outside.hpp", "secret");
  fs::create_symlink(folder.path() / "outside.hpp", from / "link.hpp");
  const LentHeaders lent(from, to,
                         "#include \"plan.hpp\"\n#include \"link.hpp\"\n#include \"gone.hpp\"\n"
                         "#include \"../outside.hpp\"\n");
  EXPECT_EQ(lent.folder(), to);
  EXPECT_EQ(DiskFiles(to).list_below(""),
            (std::vector<std::string>{"parts/a.hpp", "parts/b.hpp", "plan.hpp"}));

  Compiled compiled;
  compiled.messages = {{to / "plan.hpp", 1, 1, "error", "x"}, {"examples/a.cpp", 1, 1, "", ""}};
  compiled.dependencies = {{to / "parts/a.hpp", "/usr/include/stdio.h"}};
  lent.name_originals(compiled);
  EXPECT_EQ(compiled.messages[0].file, from / "plan.hpp");
  EXPECT_EQ(compiled.messages[1].file, "examples/a.cpp");
  EXPECT_EQ(*compiled.dependencies,
            (std::vector<std::string>{from / "parts/a.hpp", "/usr/include/stdio.h"}));
}

TEST(LentHeaders, MayIncludeEachOtherInAChainOfAnyLength) {
  const TemporaryFolder folder;
  constexpr std::size_t kLength = 20000;
  for (std::size_t i = 0; i < kLength; ++i) {
    write_file(folder.path() / (std::to_string(i) + ".hpp"),
               "#include \"" + std::to_string(i + 1) + ".hpp\"\n");
  }
  EXPECT_EQ(included_headers(DiskFiles(folder.path()), "#include \"0.hpp\"\n").size(), kLength);
}

TEST(LentHeaders, AreNoneOfAProgramThatIncludesNone) {
  const TemporaryFolder folder;
  EXPECT_EQ(LentHeaders(folder.path(), folder.path() / "lent", "#include <vector>\n").folder(), "");
  EXPECT_EQ(LentHeaders("", folder.path() / "lent", "#include \"a.h\"\n").folder(), "");
  EXPECT_FALSE(fs::exists(folder.path() / "lent"));
}

}  // namespace
}  // namespace mjcourse
