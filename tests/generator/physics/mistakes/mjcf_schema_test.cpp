#include "physics/mistakes/mjcf_schema.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace mjcourse {
namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

TEST(MjcfSchema, HasTheElements) {
  for (const char* element : {"mujoco", "worldbody", "body", "geom", "freejoint", "keyframe"}) {
    EXPECT_TRUE(has(mjcf_elements(), element)) << element;
  }
  for (const std::string& element : mjcf_elements()) {
    EXPECT_EQ(element.find_first_not_of("abcdefghijklmnopqrstuvwxyz"), std::string::npos)
        << element;
  }
}

TEST(MjcfSchema, HasTheAttributesOfAnElementFromAllItsLines) {
  EXPECT_TRUE(has(mjcf_attributes("geom"), "type"));
  EXPECT_TRUE(has(mjcf_attributes("geom"), "name"));  // not in <default>, but in <worldbody>
  EXPECT_TRUE(has(mjcf_attributes("geom"), "fromto"));
  EXPECT_TRUE(has(mjcf_attributes("body"), "mocap"));
  EXPECT_FALSE(has(mjcf_attributes("geom"), "timestep"));
  EXPECT_TRUE(mjcf_attributes("gem").empty());
}

}  // namespace
}  // namespace mjcourse
