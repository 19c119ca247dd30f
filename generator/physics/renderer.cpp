#include "physics/renderer.h"

#include <algorithm>
#include <cstdint>

#include "physics/draw_list.h"
#include "physics/mujoco_guard.h"
#include "physics/offscreen_context.h"

namespace mjcourse {
namespace {

constexpr int kLongestSide = 2048;  // pixels; with 4 samples a buffer takes 32 bytes a pixel
constexpr int film_shadow = 1024;   // texels a side
constexpr int kLarge = 64 << 20;    // bytes that are not kept for the next picture

mjvCamera free_camera(const Camera& camera) {
  mjvCamera free;
  mjv_defaultCamera(&free);
  free.type = mjCAMERA_FREE;
  free.azimuth = camera.azimuth;
  free.elevation = camera.elevation;
  free.distance = camera.distance;
  std::copy(camera.target.begin(), camera.target.end(), free.lookat);
  return free;
}

// Says which texture is larger than the current context can hold; "" where none is.
std::string too_large_texture(const Model& model) {
  for (int id = 0; id < model->ntex; ++id) {
    const bool is_flat = model->tex_type[id] == mjTEXTURE_2D;
    const int width = model->tex_width[id], height = model->tex_height[id];
    GLint most = 0;
    glGetIntegerv(is_flat ? GL_MAX_TEXTURE_SIZE : GL_MAX_CUBE_MAP_TEXTURE_SIZE, &most);
    if ((is_flat ? std::max(width, height) : width) <= most) continue;
    const std::string name = model.name(mjOBJ_TEXTURE, id);
    return "its texture " + (name.empty() ? std::to_string(id) : "`" + name + "`") + " has " +
           std::to_string(width) + " x " + std::to_string(height) +
           " pixels, and a side may have at most " + std::to_string(most);
  }
  return "";
}

// What the current framebuffer shows, OpenGL's bottom row first turned to the top row first.
Picture read_picture(PictureSize size, const mjrContext& context) {
  const std::ptrdiff_t row = std::ptrdiff_t{3} * size.width;
  Picture picture{size.width, size.height, {}};
  picture.rgb.resize(static_cast<std::size_t>(row * size.height));
  mjr_readPixels(picture.rgb.data(), nullptr, {0, 0, size.width, size.height}, &context);
  const auto first = picture.rgb.begin(), end = picture.rgb.end();
  for (std::ptrdiff_t y = 0; y < size.height / 2; ++y) {
    std::swap_ranges(first + y * row, first + (y + 1) * row, end - (y + 1) * row);
  }
  return picture;
}

}  // namespace

// What is set up once, and what is made for the model drawn last.
struct Renderer::Stage {
  OffscreenContext opengl;
  DrawList shapes;
  mjrContext context;
  std::uint64_t model = 0;         // serial number of the model that all of this is for
  Detail detail = Detail::still;   // and how finely it draws
  std::unique_ptr<Data> stand_in;  // takes the place of a simulation's data

  Stage() { mjr_defaultContext(&context); }
  ~Stage() { clear(); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  bool suits(const Model& next, PictureSize size, Detail wanted) const {
    return model == next.serial() && detail == wanted && size.width <= context.offWidth &&
           size.height <= context.offHeight;
  }
  void set(const Model& next, PictureSize size, Detail wanted);
  // False, and nothing is drawn, where there are too many shapes.
  bool draw(const Simulation& simulation, const mjvOption& options, mjvCamera camera,
            PictureSize size);
  void clear();
};

// Makes `next` the model that is drawn, at up to `size`.
void Renderer::Stage::set(const Model& next, PictureSize size, Detail wanted) {
  clear();
  stand_in = std::make_unique<Data>(next);
  shapes.make(next.get());
  shapes.scene().flags[mjRND_SHADOW] = 1;
  shapes.scene().flags[mjRND_REFLECTION] = 1;
  // The framebuffer's size and its quality are settings of the model, whose own say nothing of the
  // pictures asked for here: a shallow copy says it.
  mjModel sized = *next.get();
  sized.vis.global.offwidth = size.width;
  sized.vis.global.offheight = size.height;
  if (wanted == Detail::film) {
    sized.vis.quality.offsamples = 0;
    sized.vis.quality.shadowsize = std::min(sized.vis.quality.shadowsize, film_shadow);
  }
  mjr_makeContext(&sized, &context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  model = next.serial();
  detail = wanted;
}

// mj_forward brings what is drawn up to date with the state. On the simulation's own data it would
// also change the solver's warm start, and with it the last bits of every later step.
bool Renderer::Stage::draw(const Simulation& simulation, const mjvOption& options, mjvCamera camera,
                           PictureSize size) {
  const mjModel* drawn = simulation.model().get();
  mjData* data = stand_in->get();
  mj_copyData(data, drawn, simulation.data().get());
  mj_forward(drawn, data);
  if (!shapes.update(drawn, data, options, nullptr, camera)) return false;
  mjr_render({0, 0, size.width, size.height}, &shapes.scene(), &context);
  return true;
}

void Renderer::Stage::clear() {
  model = 0;
  stand_in.reset();
  if (!opengl.make_current()) return;
  mjr_freeContext(&context);
  shapes.clear();
}

Renderer::Renderer(std::unique_ptr<Stage> stage) : stage_(std::move(stage)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

tl::expected<Renderer, std::string> Renderer::create() {
  install_mujoco_guard();
  auto stage = std::make_unique<Stage>();
  if (!stage->opengl.make_current()) {
    return tl::unexpected<std::string>("OSMesa cannot make an OpenGL context");
  }
  return Renderer(std::move(stage));
}

tl::expected<Picture, std::string> Renderer::render(const Simulation& simulation,
                                                    const Camera& camera, const Overlays& overlays,
                                                    PictureSize size, Detail detail) {
  if (simulation.stopped()) return tl::unexpected(simulation.trouble()->what);
  const auto options = visual_options(overlays);
  if (!options) return tl::unexpected(options.error());
  if (std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > kLongestSide) {
    return tl::unexpected("a picture's sides are 1 to " + std::to_string(kLongestSide) + " pixels");
  }
  if (!stage_->opengl.make_current()) {
    return tl::unexpected<std::string>("OSMesa lost its OpenGL context");
  }
  const WarningLog log;
  try {
    if (!stage_->suits(simulation.model(), size, detail)) {
      const std::string too_large = too_large_texture(simulation.model());
      if (!too_large.empty()) return tl::unexpected(too_large);
      stage_->set(simulation.model(), size, detail);
    }
    if (!stage_->draw(simulation, *options, free_camera(camera), size)) {
      return tl::unexpected("it has more than " + std::to_string(kMostShapes) +
                            " shapes; geoms in a `group` above 2 are not drawn");
    }
  } catch (const MujocoError& error) {
    return tl::unexpected(std::string(error.what()));
  }
  if (!log.warnings().empty()) return tl::unexpected(log.warnings().front());
  Picture picture = read_picture(size, stage_->context);
  if (detail == Detail::still) let_go();
  return picture;
}

void Renderer::let_go() {
  if (stage_->stand_in && (*stage_->stand_in)->nbuffer > kLarge) stage_->clear();
}

}  // namespace mjcourse
