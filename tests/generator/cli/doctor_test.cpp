#include <gtest/gtest.h>

#include <cstdlib>

#include "base/temporary_folder.h"
#include "cli/ran.h"

namespace mjcourse {
namespace {

TEST(Doctor, FindsWhatCoursesNeed) {
  setenv("MJCOURSE_ASSETS", MJCOURSE_ASSETS, 1);
  const TemporaryFolder folder;
  const std::string store = folder.path() / "not" / "made";
  const Ran result = ran({"doctor", "--store", store});
  EXPECT_EQ(result.code, kClean) << result.out;
  EXPECT_NE(result.out.find("  store     " + store + ", 0 bytes; "), std::string::npos)
      << result.out;
  EXPECT_TRUE(result.out.starts_with("mjcourse 0.")) << result.out;
  for (const std::string line :
       {"\nok    MuJoCo    2.2.2\n", "\nok    pictures  drawn by OSMesa", "compiler  clang ",
        "  site      ", "  sandbox   rlimits", "\nall that courses need is here\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
  unsetenv("MJCOURSE_ASSETS");
}

TEST(Doctor, HasACureForWhatIsMissing) {
  const char* found = std::getenv("PATH");
  const std::string path = found != nullptr ? found : "";
  setenv("PATH", "/nowhere", 1);
  setenv("MJCOURSE_ASSETS", "/nowhere", 1);
  const TemporaryFolder store;
  const Ran result = ran({"doctor", "--store", store.path().string()});
  setenv("PATH", path.c_str(), 1);
  unsetenv("MJCOURSE_ASSETS");
  EXPECT_EQ(result.code, kCourseErrors);
  for (const std::string line :
       {"\nFAIL  compiler  none: no program can be run\n"
        "      cure: `apt-get install clang-16 mold libmujoco-dev libeigen3-dev`\n",
        "\nFAIL  films     no ffmpeg: no figure can move\n      cure: `apt-get install ffmpeg`\n",
        "\nFAIL  site      its scripts and styles were not built: manifest.json: No such file or "
        "directory\n      cure: build them: `./mjcourse build`\n",
        "\n3 things that courses need are missing\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
}

}  // namespace
}  // namespace mjcourse
