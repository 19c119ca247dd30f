#include "toolchain/page_toolchain.h"

#include <gtest/gtest.h>

#include "toolchain/scripted_page.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

TEST(PageToolchain, IsNoneWhereAPartIsMissing) {
  EXPECT_EQ(PageToolchain::find({}), nullptr);
  for (const char* part : {"version", "node", "run.mjs", "header.pch", "engine/engine.wasm"}) {
    const ScriptedPage page;
    EXPECT_NE(PageToolchain::find(page.folder()), nullptr);
    fs::remove(page.folder() / part);
    EXPECT_EQ(PageToolchain::find(page.folder()), nullptr) << part;
  }
}

TEST(PageToolchain, HasAnotherVersionWithAnotherPart) {
  const ScriptedPage page;
  const auto version = [&] { return PageToolchain::find(page.folder())->version(); };
  const std::string first = version();
  EXPECT_EQ(version(), first);
  for (const char* part : {"version", "run.mjs", "engine/engine.mjs", "engine/engine.wasm"}) {
    const std::string before = version();
    write_file(page.folder() / part, "2\n");
    EXPECT_NE(version(), before) << part;
  }
}

}  // namespace
}  // namespace mjcourse
