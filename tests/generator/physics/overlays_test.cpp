#include "physics/overlays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace mjcourse {
namespace {

// An mjvOption, comparable.
std::string bytes_of(const mjvOption& option) {
  return {reinterpret_cast<const char*>(&option), sizeof option};
}

TEST(Overlays, SetMujocosOptions) {
  const mjvOption option = visual_options({{"frames", true}, {"joints", true}}).value();
  EXPECT_EQ(option.frame, mjFRAME_BODY);
  EXPECT_EQ(option.label, mjLABEL_NONE);
  EXPECT_EQ(option.flags[mjVIS_JOINT], 1);
  EXPECT_EQ(option.flags[mjVIS_CONTACTPOINT], 0);
}

TEST(Overlays, NotNamedStayAtMujocosDefault) {
  mjvOption standard;
  mjv_defaultOption(&standard);
  const mjvOption option = visual_options({}).value();
  EXPECT_TRUE(std::equal(option.flags, option.flags + mjNVISFLAG, standard.flags));
  EXPECT_EQ(option.flags[mjVIS_TENDON], 1);
  EXPECT_EQ(visual_options({{"tendons", false}})->flags[mjVIS_TENDON], 0);
}

TEST(Overlays, TellWhichAreOn) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(overlays_in(*visual_options({})), Names{"tendons"});
  EXPECT_EQ(overlays_in(*visual_options({{"tendons", false}})), Names{});
  EXPECT_EQ(overlays_in(*visual_options({{"labels", true}, {"com", true}, {"joints", false}})),
            (Names{"labels", "com", "tendons"}));
}

TEST(Overlays, OffLeavesAnothersFramesAlone) {
  EXPECT_EQ(visual_options({{"frames", true}, {"geom-frames", false}})->frame, mjFRAME_BODY);
  EXPECT_EQ(visual_options({{"geom-frames", true}, {"site-frames", false}})->frame, mjFRAME_GEOM);
}

TEST(Overlays, UnknownNamesAreErrors) {
  EXPECT_EQ(visual_options({{"frame", true}}).error(),
            "there is no overlay `frame`; did you mean `frames`?");
}

TEST(Overlays, TwoKindsOfFramesAreAnError) {
  EXPECT_EQ(visual_options({{"frames", true}, {"geom-frames", true}}).error(),
            "MuJoCo draws one kind of frame and one of label at a time: `frames` or `geom-frames`");
  EXPECT_TRUE(visual_options({{"frames", true}, {"labels", true}}).has_value());
}

TEST(Overlays, EachNameTurnsItsOwnSettingOnAndOff) {
  std::set<std::string> settings;
  for (const std::string& name : overlay_names()) {
    const auto on = visual_options({{name, true}});
    const auto off = visual_options({{name, false}});
    ASSERT_TRUE(on.has_value() && off.has_value()) << name;
    EXPECT_NE(bytes_of(*on), bytes_of(*off)) << name;
    EXPECT_TRUE(settings.insert(bytes_of(*on)).second || name == "tendons") << name;
  }
}

}  // namespace
}  // namespace mjcourse
