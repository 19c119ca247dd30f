#include "toolchain/warm_header.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

class WarmRoots : public testing::Test {
 protected:
  // The roots for a program that begins with these includes.
  std::vector<std::string> roots(const std::string& program) const {
    return warm_roots(program, {folder_.path()});
  }
  void SetUp() override {
    write_file(folder_.path() / "kit/kit.h", "");
    write_file(folder_.path() / "kit/more.h", "");
  }
  using Names = std::vector<std::string>;
  TemporaryFolder folder_;
};

TEST_F(WarmRoots, AreTheCoursesOwnHeaders) {
  EXPECT_EQ(roots("#include <cmath>\n#include <kit/kit.h>\n#include <vector>\nint main() {}\n"),
            Names{"kit/kit.h"});
  EXPECT_EQ(roots("#include <mujoco/mjxmacro.h>\n\n#include <kit/kit.h>\n"), Names{"kit/kit.h"});
  EXPECT_EQ(roots("#include <kit/more.h>\n#include <Eigen/Core>\n#include <kit/kit.h>\n"),
            (Names{"kit/more.h", "kit/kit.h"}));
}

TEST_F(WarmRoots, AreSharedByHeadersThatBeginWithAnother) {
  const std::string begin = "// A hand.\n#pragma once\n\n#include <cmath>\n#include <kit/kit.h>\n";
  write_file(folder_.path() / "kit/hand.h", begin);
  write_file(folder_.path() / "kit/trial.h", "#include <kit/hand.h>\n");
  EXPECT_EQ(roots("#include <kit/trial.h>\n#include <kit/hand.h>\n"), Names{"kit/kit.h"});
  EXPECT_EQ(roots("#include <GL/osmesa.h>\n#include <kit/hand.h>\n"), Names{"kit/kit.h"});
  write_file(folder_.path() / "kit/own.h", "struct Early {};\n#include <kit/kit.h>\n");
  EXPECT_EQ(roots("#include <kit/own.h>\n"), Names{"kit/own.h"});
  write_file(folder_.path() / "kit/round.h", "#pragma once\n#include <kit/round.h>\n");
  EXPECT_EQ(roots("#include <kit/round.h>\n"), Names{"kit/round.h"});
}

TEST_F(WarmRoots, AreEigensWithoutOne) {
  EXPECT_EQ(roots("#include <mujoco/mujoco.h>\n\n#include <Eigen/Dense>\n#include <cmath>\n"),
            Names{"Eigen/Dense"});
}

TEST_F(WarmRoots, AreNoneWhereNothingIsToBeGained) {
  EXPECT_EQ(roots("#include <cmath>\n#include <mujoco/mujoco.h>\n"), Names{});
}

// A name that a compiled header brings must be one that the program could use there anyway.
TEST_F(WarmRoots, AreNotBehindWhatCouldUseOrChangeThem) {
  for (const char* before : {"#define EIGEN_NO_DEBUG", "struct Early {};", "#include \"own.h\"",
                             "#include <complex.h>", "#include <boost/any.hpp>", "#if 0"}) {
    EXPECT_EQ(roots(std::string(before) + "\n#include <kit/kit.h>\n"), Names{}) << before;
  }
}

TEST_F(WarmRoots, AreNotLookedForBesideTheProgram) {
  EXPECT_EQ(roots("#include \"kit/kit.h\"\n"), Names{});
}

}  // namespace
}  // namespace mjcourse
