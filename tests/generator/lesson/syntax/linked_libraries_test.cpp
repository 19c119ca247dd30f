#include "lesson/syntax/linked_libraries.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

TEST(LinkedLibraries, AreMuJoCoAlone) {
  EXPECT_EQ(linked_libraries("#include <mujoco/mujoco.h>\nint main() {}\n"), Names{"mujoco"});
  EXPECT_EQ(linked_libraries("// #include <GL/osmesa.h>\nint main() {}\n"), Names{"mujoco"});
}

TEST(LinkedLibraries, HaveOSMesaForAProgramThatDraws) {
  EXPECT_EQ(linked_libraries("#line 3 \"a.md\"\n#include <cstdio>\n#include <GL/osmesa.h>\n"),
            (Names{"mujoco", "OSMesa"}));
}

}  // namespace
}  // namespace mjcourse
