// Pictures of simulations, drawn by MuJoCo's own renderer without a screen.
//
// Renderer::create() makes an OpenGL context in memory (OSMesa, on the CPU) and render() draws with
// it. A picture at 640 x 400 takes some 50 ms. What is uploaded for a model that is not large is
// kept for the next picture of the same simulation, and for no other. Another simulation may look
// alike, but drawn with what is kept it differs in some pixels by what was drawn before. Repeated
// on the same kind of CPU, a picture is the same to the bit; across kinds of CPU compare with a
// tolerance.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <tl/expected.hpp>

#include "physics/overlays.h"
#include "physics/picture.h"
#include "physics/simulation.h"

namespace mjcourse {

// MuJoCo's free camera: it looks at `target` from `distance`.
struct Camera {
  double azimuth = 90;                    // degrees; 90 looks along +y, -90 along -y
  double elevation = -45;                 // degrees; negative looks down from above
  double distance = 2;                    // metres
  std::array<double, 3> target{0, 0, 0};  // metres, in the world frame
};

// How finely edges and shadows are drawn.
enum class Detail {
  still,  // as the model's own visual/quality says
  // For the pictures of a film: without multisampling, and with a shadow map of at most 1024 texels
  // a side. In motion and compressed, what is lost cannot be seen at the page's size; a frame takes
  // a third of the CPU.
  film,
};

struct PictureSize {
  int width = 640;
  int height = 400;
};

class Renderer {
 public:
  // An error where OSMesa cannot make a context: the picture is then missing, not the build.
  static tl::expected<Renderer, std::string> create();

  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  // Draws the state that `simulation` is in, and leaves the simulation as it is to the last bit.
  // Errors: a simulation that has stopped(), unknown overlays, a size that cannot be drawn, what
  // MuJoCo's renderer objects to. From one thread at a time.
  tl::expected<Picture, std::string> render(const Simulation& simulation, const Camera& camera,
                                            const Overlays& overlays = {}, PictureSize size = {},
                                            Detail detail = Detail::still);

  // Forgets the model drawn last where it takes much memory, as after each picture that is no
  // film's.
  void let_go();

 private:
  struct Stage;
  explicit Renderer(std::unique_ptr<Stage> stage);
  std::unique_ptr<Stage> stage_;
};

}  // namespace mjcourse
