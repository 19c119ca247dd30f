#include "physics/model_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "physics/simulation.h"

namespace mjcourse {
namespace {

constexpr const char* kSwing =
    "<mujoco><asset><texture type='skybox' builtin='gradient' rgb1='1 0 0' rgb2='0 0 1' width='8' "
    "height='48'/></asset><worldbody><body><joint name='hinge' axis='0 1 0'/>"
    "<geom size='0.1' pos='0.3 0 0'/></body></worldbody></mujoco>";

// Where a second of simulation leads.
double angle(Model model) {
  Simulation simulation(std::move(model));
  simulation.advance(1);
  return simulation.data()->qpos[0];
}

std::string buffer(const Model& model) {
  return {static_cast<const char*>(model->buffer), static_cast<std::size_t>(model->nbuffer)};
}

TEST(ModelCache, GivesWhatLoadingGives) {
  ModelCache cache;
  const Model loaded = load_model_text(kSwing).value();
  for (int i = 0; i < 2; ++i) {
    const Model given = cache.text(kSwing).value();
    EXPECT_EQ(buffer(given), buffer(loaded));
    EXPECT_EQ(std::memcmp(&given->opt, &loaded->opt, sizeof given->opt), 0);
    EXPECT_EQ(angle(cache.text(kSwing).value()), angle(load_model_text(kSwing).value()));
  }
}

TEST(ModelCache, GivesModelsThatShareNothing) {
  ModelCache cache;
  Model changed = cache.text(kSwing).value();
  const std::uint64_t serial = changed.serial();
  changed->opt.gravity[2] = 0;
  changed->body_mass[1] = 100;
  const Model next = cache.text(kSwing).value();
  EXPECT_EQ(next->opt.gravity[2], -9.81);
  EXPECT_NE(next->body_mass[1], 100);
  EXPECT_NE(next.serial(), serial);
}

TEST(ModelCache, CompilesAFileAgainWhenItChanges) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "a.xml", part = folder.path() / "part.xml";
  write_file(path, "<mujoco><include file='part.xml'/></mujoco>");
  write_file(part, "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>");
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ModelCache cache;
  EXPECT_EQ(cache.file(folder.path(), "a.xml").value()->geom_size[0], 1);
  EXPECT_EQ(cache.file(folder.path(), "a.xml").value()->geom_size[0], 1);
  write_file(part, "<mujoco><worldbody><geom size='2'/></worldbody></mujoco>");
  EXPECT_EQ(cache.file(folder.path(), "a.xml").value()->geom_size[0], 2);
  write_file(part, "<mujoco><worldbody><geom size='3'/></worldbody></mujoco>");
  EXPECT_EQ(cache.file(folder.path(), "a.xml").value()->geom_size[0], 3) << "within the same tick";
  std::filesystem::remove(path);
  EXPECT_FALSE(cache.file(folder.path(), "a.xml"));
}

TEST(ModelCache, GivesTheErrorEachTime) {
  ModelCache cache;
  for (int i = 0; i < 2; ++i) {
    const auto model = cache.text("<mujoco>\n<worldbdy/></mujoco>");
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().line, 2);
  }
}

}  // namespace
}  // namespace mjcourse
