#include "physics/renderer.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

Simulation simulate(const std::string& mjcf) {
  auto model = load_model_text(mjcf);
  EXPECT_TRUE(model.has_value()) << model.error().message;
  return Simulation(std::move(model.value()));
}

// A ball whose colour comes from a texture, which has to be uploaded for each model.
std::string sphere(const std::string& rgb) {
  return "<mujoco><asset><texture name='paint' type='cube' builtin='flat' width='32' height='192' "
         "rgb1='" +
         rgb + "' rgb2='" + rgb +
         "'/><material name='paint' texture='paint'/></asset><worldbody>"
         "<light pos='0 -3 3' dir='0 1 -1'/>"
         "<body><freejoint/><geom size='0.3' material='paint'/></body></worldbody></mujoco>";
}

const std::string red = sphere("1 0 0");
const std::string blue = sphere("0 0 1");

// A tendon of `count` pieces behind the camera, and after it one that is seen.
std::string long_tendon(int count) {
  std::string path;
  for (int i = 0; i <= count; ++i) path += i % 2 == 0 ? "<site site='a'/>" : "<site site='b'/>";
  return "<mujoco><worldbody><light pos='0 -3 3' dir='0 1 -1'/><site name='a' pos='0 -9 0'/>"
         "<site name='b' pos='0 -8 0'/><site name='c' pos='0 0 .3'/><site "
         "name='d'/></worldbody><tendon><spatial>" +
         path +
         "</spatial><spatial width='0.3' rgba='1 0 0 1'><site site='c'/><site site='d'/></spatial>"
         "</tendon></mujoco>";
}

// From -y, level with the target; x to the right, z up.
Camera looking_at(std::array<double, 3> target) {
  return {.azimuth = 90, .elevation = 0, .distance = 3, .target = target};
}

struct Pixel {
  int r, g, b;
  bool is_red() const { return r > 60 && r > 3 * g && r > 3 * b; }
  bool is_blue() const { return b > 60 && b > 3 * r && b > 3 * g; }
};

// The pixel at (x, y), fractions of the picture from its top left corner.
Pixel at(const Picture& picture, double x, double y) {
  const auto column = static_cast<std::size_t>(x * picture.width);
  const auto row = static_cast<std::size_t>(y * picture.height);
  const std::uint8_t* rgb =
      &picture.rgb[(row * static_cast<std::size_t>(picture.width) + column) * 3];
  return {rgb[0], rgb[1], rgb[2]};
}

class RendererTest : public testing::Test {
 protected:
  Picture draw(Simulation& simulation, const Camera& camera, const Overlays& overlays = {},
               PictureSize size = {160, 100}) {
    auto picture = renderer_.render(simulation, camera, overlays, size);
    EXPECT_TRUE(picture.has_value()) << picture.error();
    return picture.value_or(Picture{});
  }

  Renderer renderer_ = Renderer::create().value();
};

TEST_F(RendererTest, DrawsASphereInTheMiddle) {
  Simulation simulation = simulate(red);
  const Picture picture = draw(simulation, looking_at({0, 0, 0}));
  EXPECT_EQ(picture.width, 160);
  EXPECT_EQ(picture.height, 100);
  ASSERT_EQ(picture.rgb.size(), 160u * 100u * 3u);
  EXPECT_TRUE(at(picture, 0.5, 0.5).is_red());
  EXPECT_FALSE(at(picture, 0.1, 0.5).is_red());
  EXPECT_FALSE(at(picture, 0.9, 0.9).is_red());
}

TEST_F(RendererTest, IsTheRightWayUpAndRound) {
  Simulation simulation = simulate(red);
  const Picture above = draw(simulation, looking_at({0, 0, -0.6}));
  EXPECT_TRUE(at(above, 0.5, 0.25).is_red());
  EXPECT_FALSE(at(above, 0.5, 0.75).is_red());
  const Picture right = draw(simulation, looking_at({-0.9, 0, 0}));
  EXPECT_TRUE(at(right, 0.73, 0.5).is_red());
  EXPECT_FALSE(at(right, 0.27, 0.5).is_red());
}

TEST_F(RendererTest, RepeatsToTheByte) {
  Simulation simulation = simulate(red);
  const Picture first = draw(simulation, looking_at({0, 0, 0}));
  EXPECT_EQ(draw(simulation, looking_at({0, 0, 0})).rgb, first.rgb);
  Renderer another = Renderer::create().value();
  Simulation again = simulate(red);
  EXPECT_EQ(another.render(again, looking_at({0, 0, 0}), {}, {160, 100})->rgb, first.rgb);
}

TEST_F(RendererTest, SmoothsEdges) {
  Simulation simulation = simulate(
      "<mujoco><visual><headlight ambient='1 1 1' diffuse='0 0 0' "
      "specular='0 0 0'/></visual><worldbody><geom type='box' "
      "euler='0 20 0' size='0.4 0.4 0.4' rgba='1 1 1 1'/></worldbody>"
      "</mujoco>");
  const Picture picture = draw(simulation, looking_at({0, 0, 0}));
  int between = 0;
  for (const std::uint8_t value : picture.rgb) between += value > 20 && value < 235;
  EXPECT_GT(between, 100);
}

TEST_F(RendererTest, DrawsModelsInTurnAndAtAnySize) {
  Simulation one = simulate(red);
  Simulation other = simulate(blue);
  for (int i = 0; i < 2; ++i) {
    EXPECT_TRUE(at(draw(one, looking_at({0, 0, 0})), 0.5, 0.5).is_red());
    EXPECT_TRUE(at(draw(other, looking_at({0, 0, 0})), 0.5, 0.5).is_blue());
  }
  const Picture large = draw(other, looking_at({0, 0, -0.6}), {}, {1280, 800});
  EXPECT_TRUE(at(large, 0.5, 0.25).is_blue());
  EXPECT_EQ(draw(other, looking_at({0, 0, 0}), {}, {7, 5}).rgb.size(), 7u * 5u * 3u);
  EXPECT_EQ(other.model()->vis.global.offwidth, 640);  // the model's own value
}

TEST_F(RendererTest, DrawsAModelLikeTheLastWithWhatIsItsOwn) {
  const auto model_of = [](const std::string& geoms) {
    return simulate("<mujoco><worldbody>" + geoms + "</worldbody></mujoco>");
  };
  Simulation one = model_of("<geom size='0.3' rgba='1 0 0 1'/>");
  Simulation other = model_of("<body><freejoint/><geom size='0.3' rgba='0 0 1 1'/></body>");
  EXPECT_TRUE(at(draw(one, looking_at({0, 0, 0})), 0.5, 0.5).is_red());
  const Picture after = draw(other, looking_at({0, 0, 0}));
  EXPECT_TRUE(at(after, 0.5, 0.5).is_blue());
  Renderer fresh = Renderer::create().value();
  EXPECT_EQ(fresh.render(other, looking_at({0, 0, 0}), {}, {160, 100})->rgb, after.rgb);
}

TEST_F(RendererTest, DrawsFilmsBetweenStills) {
  Simulation one = simulate(red);
  Simulation other = simulate(blue);
  const Picture still = draw(one, looking_at({0, 0, 0}));
  const auto film = [&](Simulation& simulation) {
    return renderer_.render(simulation, looking_at({0, 0, 0}), {}, {160, 100}, Detail::film)
        .value();
  };
  EXPECT_TRUE(at(film(other), 0.5, 0.5).is_blue());
  EXPECT_EQ(draw(one, looking_at({0, 0, 0})).rgb, still.rgb);
  EXPECT_TRUE(at(film(one), 0.5, 0.5).is_red());
  EXPECT_NE(film(one).rgb, still.rgb);  // its edges are not smoothed
}

TEST_F(RendererTest, DrawsWhatTheStateIsNow) {
  Simulation simulation = simulate(red);
  simulation.data()->qpos[2] = 5;
  EXPECT_FALSE(at(draw(simulation, looking_at({0, 0, 0})), 0.5, 0.5).is_red());
}

TEST_F(RendererTest, DrawsOverlays) {
  Simulation simulation = simulate(red);
  const Picture plain = draw(simulation, looking_at({0, 0, 0}));
  for (const std::string name : {"frames", "labels", "transparent", "inertia"}) {
    EXPECT_NE(draw(simulation, looking_at({0, 0, 0}), {{name, true}}).rgb, plain.rgb) << name;
  }
}

TEST_F(RendererTest, DrawsAllShapesOfALargeModel) {
  Simulation simulation = simulate(long_tendon(12000));
  EXPECT_TRUE(at(draw(simulation, looking_at({0, 0, 0})), 0.5, 0.5).is_red());
}

TEST_F(RendererTest, LeavesTheSimulationAsItWas) {
  const std::string mjcf = R"(<mujoco><worldbody><geom type="plane" size="5 5 1"/>
      <body pos="0 0 0.3" euler="10 20 0"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
    </worldbody></mujoco>)";
  Simulation watched = simulate(mjcf);
  Simulation alone = simulate(mjcf);
  for (int i = 0; i < 20; ++i) {
    watched.step(20);
    alone.step(20);
    draw(watched, looking_at({0, 0, 0}), {{"contacts", true}}, {32, 20});
  }
  ASSERT_GT(alone.data()->ncon, 0);
  for (int i = 0; i < alone.model()->nq; ++i) {
    EXPECT_EQ(watched.data()->qpos[i], alone.data()->qpos[i]) << i;
  }
}

TEST_F(RendererTest, SaysWhyItCannot) {
  Simulation simulation = simulate(red);
  EXPECT_EQ(renderer_.render(simulation, {}, {{"joint", true}}).error(),
            "there is no overlay `joint`; did you mean `joints`?");
  EXPECT_EQ(renderer_.render(simulation, {}, {}, {0, 10}).error(),
            "a picture's sides are 1 to 2048 pixels");
  EXPECT_FALSE(renderer_.render(simulation, {}, {}, {10, 100000}).has_value());
  EXPECT_EQ(renderer_.render(simulate(long_tendon(160000)), {}, {}, {10, 10}).error(),
            "it has more than 160000 shapes; geoms in a `group` above 2 are not drawn");
  const std::string wide =
      "<mujoco><asset><texture name='wide' type='2d' builtin='flat' width='40000' height='2'/>"
      "</asset><worldbody><geom size='1'/></worldbody></mujoco>";
  EXPECT_EQ(renderer_.render(simulate(wide), {}, {}, {10, 10}).error(),
            "its texture `wide` has 40000 x 2 pixels, and a side may have at most 16384");
}

}  // namespace
}  // namespace mjcourse
