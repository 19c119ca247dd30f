#include "physics/whole_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace mjcourse {
namespace {

constexpr double kOwnDistance = 1.5;  // of MuJoCo's view, in extents
constexpr double kFarthest = 3;       // extents
constexpr double kMargin = 1.05;
constexpr double kNearerHalf = 0.9;  // of what is drawn
constexpr double kDegree = 3.14159265358979323846 / 180;

enum Way { kTop, kBottom, kRight, kLeft, kAway, kTowards, kAxes };

constexpr double kNowhere = -std::numeric_limits<double>::infinity();

Vector sum(double a, const Vector& x, double b, const Vector& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

std::array<Vector, 12> ways_of(const Outlook& outlook, double half_fovy, double half_fovx) {
  const double a = outlook.azimuth * kDegree, e = outlook.elevation * kDegree;
  const Vector away{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
  const Vector up{-std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e)};
  const Vector right{std::sin(a), -std::cos(a), 0};
  const auto side = [&](double sign, const Vector& axis, double half) {
    return sum(sign * std::cos(half), axis, -std::sin(half), away);
  };
  return {side(1, up, half_fovy),
          side(-1, up, half_fovy),
          side(1, right, half_fovx),
          side(-1, right, half_fovx),
          away,
          sum(-1, away, 0, away),
          Vector{1, 0, 0},
          Vector{0, 1, 0},
          Vector{0, 0, 1},
          Vector{-1, 0, 0},
          Vector{0, -1, 0},
          Vector{0, 0, -1}};
}

template <typename Reach>
void widen(Reach& reach, const Reach& other) {
  for (std::size_t i = 0; i < reach.size(); ++i) reach[i] = std::max(reach[i], other[i]);
}

}  // namespace

WholeView::WholeView(const Model& model, const Outlook& outlook)
    : outlook_(outlook),
      center_{model->stat.center[0], model->stat.center[1], model->stat.center[2]},
      extent_(model->stat.extent),
      nearest_(double{model->vis.map.znear} * extent_),
      farthest_(double{model->vis.map.zfar} * extent_),
      half_fovy_(double{model->vis.global.fovy} / 2 * kDegree),
      half_fovx_(std::atan(std::tan(half_fovy_) * outlook.aspect)),
      ways_(ways_of(outlook, half_fovy_, half_fovx_)),
      shapes_(model.get()) {}

void WholeView::list(const Simulation& simulation) {
  const mjModel* model = simulation.model().get();
  auto* data = const_cast<mjData*>(simulation.data().get());  // which MuJoCo only reads
  if (listed_ != simulation.model().serial()) list_.make(model);
  listed_ = simulation.model().serial();
  mjvOption options;
  mjv_defaultOption(&options);
  mjvCamera camera;
  mjv_defaultCamera(&camera);
  list_.update(model, data, options, nullptr, camera);
}

void WholeView::add(const Simulation& simulation) {
  list(simulation);
  const bool is_first = trails_.empty();
  const mjvScene& scene = list_.scene();
  for (int i = 0; i < scene.ngeom; ++i) {
    const mjvGeom& geom = scene.geoms[i];
    const bool is_plane = geom.type == mjGEOM_PLANE;
    const bool is_infinite = is_plane && std::min(geom.size[0], geom.size[1]) <= 0;
    if (geom.category == mjCAT_DECOR || is_infinite) continue;
    const Reach reach = reach_of(geom, simulation.model().get());
    if (is_first) reach_at_first_ = std::max(reach_at_first_, farthest(reach));
    if (is_plane) continue;
    Reach nowhere;
    nowhere.fill(kNowhere);
    Trail& trail =
        trails_.try_emplace({geom.objtype, geom.objid}, Trail{nowhere, nowhere}).first->second;
    if (is_first) widen(trail.first, reach);
    widen(trail.all, reach);
    trail.is_lost |= farthest(reach) > kFarthest * std::max(extent_, reach_at_first_);
  }
}

WholeView::Reach WholeView::reach_of(const mjvGeom& geom, const mjModel* model) const {
  Reach reach;
  for (std::size_t i = 0; i < reach.size(); ++i) {
    reach[i] = shapes_.along(ways_[i], geom, model, list_.scene());
  }
  return reach;
}

// From the center to the corner of the box around it that is the farthest.
double WholeView::farthest(const Reach& reach) const {
  Vector corner;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    corner[axis] = std::max(std::abs(reach[kAxes + axis] - center_[axis]),
                            std::abs(reach[kAxes + 3 + axis] + center_[axis]));
  }
  return std::hypot(corner[0], corner[1], corner[2]);
}

WholeView::Reach WholeView::seen() const {
  Reach seen;
  seen.fill(kNowhere);
  for (const auto& [object, trail] : trails_) widen(seen, trail.is_lost ? trail.first : trail.all);
  return seen;
}

// The picture's four sides lie in planes through the camera, whose directions are known. Moved as
// far in as all allows, the upper and the lower one meet in a line, and the others in another; the
// camera is where all is between both pairs.
WholeView::Place WholeView::place() const {
  const Reach all = seen();
  const Vector& away = ways_[kAway];
  const Place own{center_, kOwnDistance * extent_};
  const Vector eye = sum(1, own.target, -own.distance, away);
  const auto holds = [&](int way) {
    return all[static_cast<std::size_t>(way)] <= dot(ways_[static_cast<std::size_t>(way)], eye);
  };
  if (holds(kTop) && holds(kBottom) && holds(kRight) && holds(kLeft)) return own;

  const double depth = std::min(-(all[kTop] + all[kBottom]) / (2 * std::sin(half_fovy_)),
                                -(all[kRight] + all[kLeft]) / (2 * std::sin(half_fovx_)));
  // From the origin, in a pair's difference of ways as in a pair's difference of reaches.
  const double up = (all[kTop] - all[kBottom]) / std::pow(2 * std::cos(half_fovy_), 2);
  const double right = (all[kRight] - all[kLeft]) / std::pow(2 * std::cos(half_fovx_), 2);
  const double middle = (all[kAway] - all[kTowards]) / 2;
  const double half_depth = (all[kAway] + all[kTowards]) / 2;
  const Vector in_plane = sum(up, sum(1, ways_[kTop], -1, ways_[kBottom]), right,
                              sum(1, ways_[kRight], -1, ways_[kLeft]));
  const double distance = std::max(kMargin * (middle - depth), half_depth + 2 * nearest_);
  // Beyond that nothing is drawn: better to cut the sides, and to see the nearer half for certain.
  const double drawn = std::max(farthest_ - half_depth, kNearerHalf * farthest_);
  return {sum(1, in_plane, middle, away), std::min(distance, drawn)};
}

}  // namespace mjcourse
