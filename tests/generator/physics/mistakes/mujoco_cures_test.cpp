#include "physics/mistakes/mujoco_cures.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(MujocoCures, SayWhatIsRight) {
  EXPECT_EQ(
      cure_of_model("object 'b': mass and inertia of moving bodies must be larger than mjMINVAL"),
      "give the body a geom that has a mass, or an `<inertial>`");
  EXPECT_EQ(cure_of_model("user has more values than nuser_geom in geom 'b' (id = 0)"),
            "write how many values there are, as `<size nuser_geom=\"3\"/>`, or fewer values");
  EXPECT_EQ(cure_of_model("texture 'wood' not found in material 0"),
            "nothing in the model has that name: look for a wrong letter, or define the texture");
  EXPECT_EQ(cure_of_model("invalid control range for actuator '' (id = 0)"),
            "write `ctrlrange=\"0 1\"`, with the lower number first");
  EXPECT_EQ(
      cure_of_model("object 'cube': faces have inconsistent orientation: cube"),
      "let all faces go round the same way: a program for meshes can recompute their normals");
  EXPECT_EQ(cure_of_model("inertia must satisfy A + B >= C; use 'balanceinertia' to fix"),
            "write the inertia of a real body, or `<compiler balanceinertia=\"true\"/>`");
  EXPECT_EQ(cure_of_model("repeated name in geom array, position 1"),
            "give each a name of its own");
  EXPECT_EQ(cure_of_model("element 'geom': problem reading attribute 'size'"),
            "write numbers in `size`, with spaces between them");
  EXPECT_EQ(cure_of_model("element 'geom': attribute 'quat' has too much data"),
            "write fewer numbers in `quat`");
  EXPECT_EQ(cure_of_model("element 'geom': attribute 'quat' does not have enough data"),
            "write more numbers in `quat`");
  EXPECT_EQ(cure_of_model("element 'mesh': required attribute missing: 'file'"),
            "write `file=\"…\"` there");
  EXPECT_EQ(cure_of_model("element 'joint': World body cannot have joints"),
            "write the joints of a `<body>` in it");
  EXPECT_EQ(cure_of_model("something else"), "");
}

}  // namespace
}  // namespace mjcourse
