#include "lsp/model_names.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kPendulum =
    "<mujoco><worldbody><body name='arm'><joint name='hinge'/><joint/><geom name='rod' size='1'/>"
    "<site name='tip'/></body></worldbody><actuator><motor name='push' joint='hinge'/></actuator>"
    "<sensor><jointpos name='angle' joint='hinge'/></sensor></mujoco>";

bool has(const Names& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

TEST(ModelNames, AreTheFieldsBehindAPath) {
  const ModelNames names("/nowhere");
  EXPECT_TRUE(has(names.fields("data"), "qpos"));
  EXPECT_TRUE(has(names.fields("model"), "nq"));
  EXPECT_FALSE(has(names.fields("model"), "qpos"));
  EXPECT_EQ(names.fields("dat"), Names());
  EXPECT_EQ(names.fields("data.qpos"), Names());
}

TEST(ModelNames, NameAStructureOnceAndItsFieldsBehindIt) {
  const Names of_model = ModelNames("/nowhere").fields("model");
  EXPECT_EQ(std::ranges::count(of_model, "opt"), 1);
  EXPECT_TRUE(std::ranges::is_sorted(of_model));
  EXPECT_TRUE(has(ModelNames("/nowhere").fields("model.opt"), "timestep"));
}

TEST(ModelNames, AreTheObjectsThatALookupFinds) {
  ModelNames names("/nowhere");
  EXPECT_EQ(names.objects(kPendulum, "qpos"), Names{"hinge"});
  EXPECT_EQ(names.objects(kPendulum, "qvel"), Names{"hinge"});
  EXPECT_EQ(names.objects(kPendulum, "joint"), Names{"hinge"});
  EXPECT_TRUE(has(names.objects(kPendulum, "body"), "arm"));
  EXPECT_EQ(names.objects(kPendulum, "geom"), Names{"rod"});
  EXPECT_EQ(names.objects(kPendulum, "site"), Names{"tip"});
  EXPECT_EQ(names.objects(kPendulum, "sensor"), Names{"angle"});
  EXPECT_EQ(names.objects(kPendulum, "ctrl"), Names{"push"});
  EXPECT_EQ(names.objects(kPendulum, "sin"), Names());
}

TEST(ModelNames, OfTheCourseAreThoseOfItsFile) {
  const TemporaryFolder folder;
  write_file(folder.path() / "models/swing.xml", kPendulum);
  write_file(folder.path() / "models/broken.xml", "<mujoco><worldbody>");
  ModelNames names(folder.path());
  EXPECT_EQ(names.objects("swing", "ctrl"), Names{"push"});
  EXPECT_EQ(names.objects("broken", "ctrl"), Names());
  EXPECT_EQ(names.objects("missing", "ctrl"), Names());
  EXPECT_EQ(names.objects("", "ctrl"), Names());
}

}  // namespace
}  // namespace mjcourse
