// What a camera has to see to see all of a model: where it stands, where it moves to, and its
// skins.
//
// MuJoCo's own `stat` knows the geoms of the initial state. What falls or swings leaves that view,
// and a skin may reach beyond the geoms that carry it.
#pragma once

#include <array>
#include <vector>

#include "physics/simulation.h"

namespace mjcourse {

class WholeView {
 public:
  // MuJoCo's view of `model`.
  explicit WholeView(const Model& model);

  // Sees as well what can move, as it is now. What once is farther away than three times the extent
  // is left out with all of its way: it falls for ever, and the rest would be a dot.
  void add(const Simulation& simulation);

  // MuJoCo's `stat.center` and `stat.extent` where these are enough, else ones that are.
  std::array<double, 3> center() const;
  double extent() const;  // metres

 private:
  // Where one geom or skin was.
  struct Trail {
    std::array<double, 3> least, most;
    double reach = 0;  // from stat_center_
  };
  void add_ball(Trail& trail, const double* center, double radius) const;
  void add_skins(const Simulation& simulation);
  // Of all that stays; MuJoCo's center where that is enough.
  Trail all() const;

  std::array<double, 3> stat_center_;
  double stat_extent_;
  std::vector<Trail> geoms_, skins_;
};

}  // namespace mjcourse
