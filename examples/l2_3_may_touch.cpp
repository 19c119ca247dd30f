// Lesson 2.3, exercise: the rules by which MuJoCo leaves pairs of geoms out.
//
// INPUT    two_stands.xml; chains of four balls below a ball of the world, on a
//          fixed and on a free base, with a welded link, with bits
// PROCESS  ask may_touch about every pair, and MuJoCo, which lists all pairs
//          that no rule leaves out where contacts begin 10 m before the touch
// OUTPUT   on how many pairs of the stands the two agree; checks the chains
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_may_touch

#include <algorithm>
#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// May these two geoms ever be in data->contact? The model has no <exclude>.
bool may_touch(const mjModel* model, int geom1, int geom2) {
  const int type1 = model->geom_contype[geom1];
  const int type2 = model->geom_contype[geom2];
  const int affinity1 = model->geom_conaffinity[geom1];
  const int affinity2 = model->geom_conaffinity[geom2];
  const int body1 = model->geom_bodyid[geom1];
  const int body2 = model->geom_bodyid[geom2];
  // #region answer
  const int weld1 = model->body_weldid[body1];
  const int weld2 = model->body_weldid[body2];
  const int parent1 = model->body_weldid[model->body_parentid[weld1]];
  const int parent2 = model->body_weldid[model->body_parentid[weld2]];
  const bool bits = (type1 & affinity2) != 0 || (type2 & affinity1) != 0;
  if (!bits || weld1 == weld2) return false;
  if (weld1 == 0 || weld2 == 0) return true;  // the world is nobody's parent
  return weld1 != parent2 && weld2 != parent1;
  // #starter
  // return (type1 & affinity2) != 0;  // which rules are missing?
  // #wrong the-world-is-a-parent: on a fixed base
  // const int weld1 = model->body_weldid[body1];
  // const int weld2 = model->body_weldid[body2];
  // const int parent1 = model->body_weldid[model->body_parentid[weld1]];
  // const int parent2 = model->body_weldid[model->body_parentid[weld2]];
  // const bool bits = (type1 & affinity2) != 0 || (type2 & affinity1) != 0;
  // return bits && weld1 != weld2 && weld1 != parent2 && weld2 != parent1;
  // #wrong forgets-welds: with a welded link
  // const int parent1 = model->body_parentid[body1];
  // const int parent2 = model->body_parentid[body2];
  // const bool fixed1 = model->body_weldid[body1] == 0;
  // const bool fixed2 = model->body_weldid[body2] == 0;
  // const bool bits = (type1 & affinity2) != 0 || (type2 & affinity1) != 0;
  // if (!bits || body1 == body2) return false;
  // if (fixed1 || fixed2) return fixed1 != fixed2;
  // return body1 != parent2 && body2 != parent1;
  // #wrong one-way: with bits of several kinds
  // const int weld1 = model->body_weldid[body1];
  // const int weld2 = model->body_weldid[body2];
  // const int parent1 = model->body_weldid[model->body_parentid[weld1]];
  // const int parent2 = model->body_weldid[model->body_parentid[weld2]];
  // if ((type1 & affinity2) == 0 || weld1 == weld2) return false;
  // if (weld1 == 0 || weld2 == 0) return true;
  // return weld1 != parent2 && weld2 != parent1;
  // #endregion
}

struct Agreement {
  int pairs = 0, agreed = 0;
  bool holds() const { return agreed == pairs; }
};

Agreement compare(const Model& model) {
  for (int geom = 0; geom < model->ngeom; ++geom)
    model->geom_margin[geom] = model->geom_gap[geom] = 10;  // m
  const Data data = make_data(model);
  mj_kinematics(model, data);
  mj_collision(model, data);
  Agreement found;
  for (int a = 0; a < model->ngeom; ++a) {
    for (int b = a + 1; b < model->ngeom; ++b) {
      const bool is_listed = std::any_of(
          data->contact, data->contact + data->ncon, [&](const mjContact& one) {
            return std::minmax(one.geom1, one.geom2) == std::minmax(a, b);
          });
      ++found.pairs;
      found.agreed += may_touch(model, a, b) == is_listed ? 1 : 0;
    }
  }
  return found;
}

// Four links. The first has the joint `base`, the third has `third`, and the first
// and the fourth have `bits`.
Agreement of_chain(const std::string& base, const std::string& third,
                   const std::string& bits = "") {
  const auto link = [](const std::string& joint, const std::string& geom) {
    return "<body pos='0.3 0 0'>" + joint + "<geom size='0.1' " + geom + "/>";
  };
  const std::string hinge = "<joint/>";
  return compare(load_model_xml(
      "<mujoco><worldbody><geom size='0.1'/>" + link(base, bits) +
      link(hinge, "") + link(third, "") + link(hinge, bits) +
      "</body></body></body></body></worldbody></mujoco>"));
}

int main() {
  const Agreement stands = compare(load_model("two_stands"));
  std::printf("two_stands: %d of %d pairs as in MuJoCo\n", stands.agreed,
              stands.pairs);

  const std::string free = "<freejoint/>", hinge = "<joint/>";
  if (!expect(of_chain("", hinge).holds(),
              "on a fixed base, the right pairs may touch",
              "neighbours do not touch, but the world is nobody's parent"))
    return 0;
  if (!expect(of_chain(free, "").holds(),
              "with a welded link, the right pairs may touch",
              "a body without a joint belongs to the one that it is in"))
    return 0;
  expect(of_chain(free, hinge, "contype='2' conaffinity='0'").holds() &&
             of_chain(free, hinge, "contype='0' conaffinity='1'").holds(),
         "with bits of several kinds, the right pairs may touch",
         "either geom's contype may meet the other's conaffinity");
}
