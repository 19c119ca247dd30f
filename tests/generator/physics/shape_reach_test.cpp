#include "physics/shape_reach.h"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/draw_list.h"
#include "physics/simulation.h"

namespace mjcourse {
namespace {

// Along `way`, of the one geom of a model.
double reach(const std::string& geom, const Vector& way, const std::string& asset = "") {
  auto model = load_model_text("<mujoco>" + asset + "<worldbody><body pos='1 2 3' euler='0 0 90'>" +
                               geom + "</body></worldbody></mujoco>");
  EXPECT_TRUE(model) << model.error().message;
  Simulation simulation(*std::move(model));
  const mjModel* drawn = simulation.model().get();
  DrawList list;
  list.make(drawn);
  mjvOption options;
  mjv_defaultOption(&options);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  list.update(drawn, simulation.data().get(), options, nullptr, camera);
  return ShapeReach(drawn).along(way, list.scene().geoms[0], drawn, list.scene());
}

constexpr Vector kX{1, 0, 0}, kDown{0, 0, -1}, kAslant{0, 0.6, 0.8};

// The geom's y is along -x, and its x along y.
TEST(ShapeReach, KnowsEachShape) {
  EXPECT_NEAR(reach("<geom size='0.5'/>", kAslant), 1.2 + 2.4 + 0.5, 1e-6);
  EXPECT_NEAR(reach("<geom type='box' size='.1 .2 .3'/>", kX), 1 + 0.2, 1e-6);
  EXPECT_NEAR(reach("<geom type='box' size='.1 .2 .3'/>", kAslant), 3.6 + 0.06 + 0.24, 1e-6);
  EXPECT_NEAR(reach("<geom type='capsule' size='.1 .3'/>", kDown), -3 + 0.4, 1e-6);
  EXPECT_NEAR(reach("<geom type='capsule' size='.1 .3'/>", kX), 1 + 0.1, 1e-6);
  EXPECT_NEAR(reach("<geom type='cylinder' size='.1 .3'/>", kAslant), 3.6 + 0.06 + 0.24, 1e-6);
  EXPECT_NEAR(reach("<geom type='ellipsoid' size='.1 .2 .3'/>", kAslant),
              3.6 + std::hypot(0.06, 0.24), 1e-6);
  EXPECT_NEAR(reach("<geom type='plane' size='.1 .2 1'/>", kX), 1 + 0.2, 1e-6);
  EXPECT_NEAR(reach("<geom type='plane' size='.1 .2 1'/>", kDown), -3, 1e-6);
}

TEST(ShapeReach, KnowsHeightFieldsAndMeshes) {
  const std::string asset =
      "<asset><hfield name='h' nrow='2' ncol='2' size='.1 .2 .3 .4'/>"
      "<mesh name='m' vertex='0 0 0 1 0 0 0 2 0 0 0 3'/></asset>";
  const std::string field = "<geom type='hfield' hfield='h'/>";
  EXPECT_NEAR(reach(field, kX, asset), 1 + 0.2, 1e-6);
  EXPECT_NEAR(reach(field, kDown, asset), -3 + 0.4, 1e-6);
  EXPECT_NEAR(reach(field, {0, 0, 1}, asset), 3 + 0.3, 1e-6);
  const std::string mesh = "<geom type='mesh' mesh='m'/>";
  EXPECT_GE(reach(mesh, kX, asset), 1 - 1e-6);
  EXPECT_GE(reach(mesh, {0, 0, 1}, asset), 6 - 1e-6);
  EXPECT_GE(reach(mesh, kDown, asset), -3 - 1e-6);
}

}  // namespace
}  // namespace mjcourse
