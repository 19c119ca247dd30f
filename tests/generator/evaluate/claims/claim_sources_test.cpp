#include "evaluate/claims/claim_sources.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

// A course whose model `cart` includes a file and has a mesh; each look is a new one.
class ClaimSourcesTest : public testing::Test {
 protected:
  ClaimSourcesTest() {
    write(
        "models/cart.xml",
        "<mujoco><include file='parts/wheel.xml'/><asset><mesh file='box.obj'/></asset></mujoco>");
    write("models/parts/wheel.xml", "<mujoco><worldbody/></mujoco>");
    write("models/box.obj", "v 0 0 0\n");
    write("models/swing.xml", "<mujoco/>");
    write("examples/include/own.h", "// own\n");
  }
  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }

  template <typename Look>
  std::string look(const Look& look) const {
    Fingerprints fingerprints(folder_.path());
    ClaimSources sources(folder_.path(), {"cart", "swing"}, {folder_.path() / "examples/include"},
                         fingerprints);
    return look(sources);
  }
  std::string model(const std::string& name) const {
    return look([&](ClaimSources& sources) { return sources.model(name); });
  }
  std::string named_in(const std::string& text) const {
    return look([&](ClaimSources& sources) { return sources.models_named_in(text); });
  }
  std::string helper() const {
    return look([](ClaimSources& sources) { return sources.helper(); });
  }

  TemporaryFolder folder_;
};

TEST_F(ClaimSourcesTest, OfAModelAreAllFilesThatItNames) {
  const std::string before = model("cart");
  EXPECT_EQ(model("cart"), before);
  write("models/parts/wheel.xml", "<mujoco><worldbody><body/></worldbody></mujoco>");
  const std::string other_part = model("cart");
  EXPECT_NE(other_part, before);
  write("models/box.obj", "v 0 0 1\n");
  EXPECT_NE(model("cart"), other_part);
}

TEST_F(ClaimSourcesTest, OfAModelAreNoOtherFiles) {
  const std::string before = model("cart");
  write("models/swing.xml", "<mujoco model='x'/>");
  write("models/parts/other.xml", "<mujoco/>");
  EXPECT_EQ(model("cart"), before);
  EXPECT_EQ(model("unknown"), "");
}

TEST_F(ClaimSourcesTest, OfATextAreTheModelsThatItNames) {
  const std::string none = named_in("swings with \"swing_2\"");
  EXPECT_NE(named_in("load(\"swing\")"), none);
  EXPECT_EQ(named_in("load(\"swing\")"), named_in("models/swing.xml"));
  EXPECT_NE(named_in("cart.xml and swing.xml"), named_in("swing.xml"));
}

TEST_F(ClaimSourcesTest, OfHeadersAreTheirNamesAndBytes) {
  const std::string before = helper();
  write("examples/include/own.h", "// other\n");
  const std::string other = helper();
  EXPECT_NE(other, before);
  std::filesystem::rename(folder_.path() / "examples/include/own.h",
                          folder_.path() / "examples/include/renamed.h");
  EXPECT_NE(helper(), other);
}

TEST(ClaimSources, AreHashedPartByPart) {
  EXPECT_NE(hash_of({"ab", "c"}), hash_of({"a", "bc"}));
  EXPECT_NE(hash_of({"a", "b"}), hash_of({"b", "a"}));
  EXPECT_NE(hash_of({}), hash_of({""}));
  EXPECT_EQ(hash_of({"a", "b"}), hash_of({"a", "b"}));
}

}  // namespace
}  // namespace mjcourse
