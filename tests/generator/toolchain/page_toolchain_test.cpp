#include "toolchain/page_toolchain.h"

#include <gtest/gtest.h>

#include "toolchain/scripted_page.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

std::string header_of(PageToolchain& toolchain) {
  const TemporaryFolder work;
  return toolchain.command(work.path()).arguments.back();
}

TEST(PageToolchain, IsNoneWhereAPartIsMissing) {
  EXPECT_EQ(PageToolchain::find({}, std::nullopt), nullptr);
  for (const char* part : {"version", "node", "run.mjs", "engine/engine.wasm"}) {
    const ScriptedPage page;
    EXPECT_NE(PageToolchain::find(page.folder(), std::nullopt), nullptr);
    fs::remove(page.folder() / part);
    EXPECT_EQ(PageToolchain::find(page.folder(), std::nullopt), nullptr) << part;
  }
}

TEST(PageToolchain, HasAnotherVersionWithAnotherPart) {
  const ScriptedPage page;
  const auto version = [&] { return PageToolchain::find(page.folder(), std::nullopt)->version(); };
  const std::string first = version();
  EXPECT_EQ(version(), first);
  for (const char* part : {"version", "run.mjs", "engine/engine.mjs", "engine/engine.wasm"}) {
    const std::string before = version();
    write_file(page.folder() / part, "2\n");
    EXPECT_NE(version(), before) << part;
  }
}

TEST(PageToolchain, KeepsItsHeaderForTheNextProcess) {
  const ScriptedPage page;
  const TemporaryFolder prepared;
  const std::string header = header_of(*PageToolchain::find(page.folder(), prepared.path()));
  EXPECT_TRUE(is_within(header, prepared.path().string())) << header;
  EXPECT_EQ(read_file(header).value(), "header\n");
  write_file(header, "kept");
  EXPECT_EQ(header_of(*PageToolchain::find(page.folder(), prepared.path())), header);
  EXPECT_EQ(read_file(header).value(), "kept");
  write_file(page.folder() / "version", "2\n");
  EXPECT_NE(header_of(*PageToolchain::find(page.folder(), prepared.path())), header);
}

TEST(PageToolchain, MakesItForItselfWhereNothingIsKept) {
  const ScriptedPage page;
  const auto toolchain = PageToolchain::find(page.folder(), std::nullopt);
  const std::string header = header_of(*toolchain);
  EXPECT_EQ(read_file(header).value(), "header\n");
  EXPECT_EQ(header_of(*toolchain), header);
}

TEST(PageToolchain, SaysWhyThereIsNoHeader) {
  const ScriptedPage page;
  write_file(page.folder() / "node", "#!/bin/sh\necho no room >&2\nexit 1\n");
  const auto toolchain = PageToolchain::find(page.folder(), std::nullopt);
  try {
    header_of(*toolchain);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the page's compiler cannot prepare its headers: no room\n");
  }
}

}  // namespace
}  // namespace mjcourse
