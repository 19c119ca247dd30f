#include "physics/mistakes/newer_mjcf.h"

#include <gtest/gtest.h>

#include "physics/mistakes/mjcf_schema.h"

namespace mjcourse {
namespace {

TEST(NewerMjcf, KnowsTheFirstVersion) {
  EXPECT_EQ(since_when_element("extension"), "2.3.0");
  EXPECT_EQ(since_when_element("flexcomp"), "3.0.0");
  EXPECT_EQ(since_when_attribute("body", "gravcomp"), "2.3.1");
  EXPECT_EQ(since_when_attribute("joint", "actuatorfrcrange"), "3.0.0");
  EXPECT_EQ(since_when_attribute("spatial", "actuatorfrcrange"), "3.3.1");
  EXPECT_EQ(since_when_keyword("option", "implicitfast"), "2.3.3");
}

TEST(NewerMjcf, KnowsNothingElse) {
  EXPECT_EQ(since_when_element("extensions"), "");
  EXPECT_EQ(since_when_element(""), "");
  EXPECT_EQ(since_when_attribute("geom", "gravcomp"), "");
  EXPECT_EQ(since_when_attribute("body", ""), "");
  EXPECT_EQ(since_when_keyword("option", "implicit"), "");
}

// What this MuJoCo has is not newer than it.
TEST(NewerMjcf, HasNothingOfThisVersion) {
  for (const std::string& element : mjcf_elements()) {
    EXPECT_EQ(since_when_element(element), "") << element;
    for (const std::string& attribute : mjcf_attributes(element)) {
      EXPECT_EQ(since_when_attribute(element, attribute), "") << element << ' ' << attribute;
    }
  }
}

}  // namespace
}  // namespace mjcourse
