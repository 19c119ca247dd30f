#include "process/mesa.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCache = "MESA_SHADER_CACHE_DIR";

// With the variables as the environment had them afterwards.
class MesaTest : public testing::Test {
 protected:
  MesaTest() {
    if (const char* set = std::getenv(kCache)) before_ = set;
  }
  ~MesaTest() override {
    if (before_) {
      setenv(kCache, before_->c_str(), 1);
    } else {
      unsetenv(kCache);
    }
  }

  TemporaryFolder folder_;
  std::optional<std::string> before_;
};

TEST_F(MesaTest, KeepsShadersInTheCacheUnlessTheUserSaysWhere) {
  unsetenv(kCache);
  set_up_mesa(std::nullopt);
  EXPECT_EQ(std::getenv(kCache), nullptr);
  set_up_mesa(folder_.path());
  EXPECT_EQ(std::getenv(kCache), folder_.path().string());
  set_up_mesa("/elsewhere");
  EXPECT_EQ(std::getenv(kCache), folder_.path().string());
}

TEST_F(MesaTest, LendsAProgramShadersThatItCanReadAndAPlaceForItsOwn) {
  const fs::path kept = folder_.path() / "kept" / "mesa_shader_cache";
  fs::create_directories(kept / "1c");
  write_file(kept / "1c" / "38e2", "a shader");
  write_file(kept / "1c" / "3f0a.tmp", "half a shader");
  write_file(kept / "index", "ours");
  setenv(kCache, (folder_.path() / "kept").c_str(), 1);

  const LentShaders lent = lend_shaders_to(folder_.path() / "lent");

  EXPECT_EQ(lent.ours, kept);
  EXPECT_EQ(lent.own, folder_.path() / "lent" / "mesa_shader_cache");
  EXPECT_EQ(lent.variables, (std::vector<std::string>{
                                std::string(kCache) + "=" + (folder_.path() / "lent").string(),
                                "MESA_DISK_CACHE_MULTI_FILE=1", "LP_NUM_THREADS=0"}));
  EXPECT_EQ(read_file(lent.own / "1c/38e2"), "a shader");
  EXPECT_FALSE(fs::exists(lent.own / "1c" / "3f0a.tmp"));
  EXPECT_FALSE(fs::exists(lent.own / "index"));
  write_file(lent.own / "1c" / "4d67", "its own");
  EXPECT_FALSE(fs::exists(kept / "1c" / "4d67"));
}

TEST_F(MesaTest, GivesAPlaceWhereNothingIsKept) {
  unsetenv(kCache);
  const LentShaders lent = lend_shaders_to(folder_.path() / "lent");
  EXPECT_EQ(lent.ours, "");
  EXPECT_TRUE(fs::is_empty(lent.own));
  setenv(kCache, (folder_.path() / "missing").c_str(), 1);
  EXPECT_EQ(lend_shaders_to(folder_.path() / "other").ours, "");
}

}  // namespace
}  // namespace mjcourse
