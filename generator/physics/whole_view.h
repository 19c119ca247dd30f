// From where a camera sees all of a model, as it stands and as it moves.
//
// That is what MuJoCo draws of it by itself: geoms, sites, tendons and skins. Of a plane, which is
// mostly a floor, it sees what lies behind the rest. MuJoCo's own view knows nothing but the geoms
// of the initial state, or what the model's `statistic` says; it is kept where all is in it.
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "physics/draw_list.h"
#include "physics/shape_reach.h"
#include "physics/simulation.h"

namespace mjcourse {

// A free camera's direction in degrees, and how many times as wide as high its picture is.
struct Outlook {
  double azimuth = 90, elevation = -45, aspect = 1;
};

class WholeView {
 public:
  WholeView(const Model& model, const Outlook& outlook);

  // Sees as well what is drawn now. What is drawn first is seen for certain. What later is farther
  // away than three times the model's extent is seen only where it was at first: it falls for ever,
  // and the rest would be a dot.
  void add(const Simulation& simulation);

  const Outlook& outlook() const { return outlook_; }
  // What the camera looks at, and from how far: MuJoCo's own where that is enough.
  struct Place {
    Vector target;
    double distance = 0;
  };
  Place place() const;

 private:
  // How far something reaches along each of ways_.
  using Reach = std::array<double, 12>;
  // Of one object of MuJoCo's.
  struct Trail {
    Reach first, all;
    bool is_lost = false;
  };
  void list(const Simulation& simulation);
  Reach reach_of(const mjvGeom& geom, const mjModel* model) const;
  double farthest(const Reach& reach) const;
  Reach seen() const;

  Outlook outlook_;
  Vector center_;
  double extent_;              // as MuJoCo has it, in metres
  double nearest_, farthest_;  // of what a camera draws
  double half_fovy_, half_fovx_;
  // Out of the picture at its top, bottom, right and left; away from the camera and towards it;
  // along the axes and against them.
  std::array<Vector, 12> ways_;
  ShapeReach shapes_;
  DrawList list_;
  std::uint64_t listed_ = 0;  // serial number of the model that the list is for
  double reach_at_first_ = 0;
  std::map<std::pair<int, int>, Trail> trails_;
};

}  // namespace mjcourse
