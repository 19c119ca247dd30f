// Lesson 2.3: how many pairs of geoms MuJoCo really compares.
//
// INPUT    balls in a row along x, apart, touching, or deep in one another
// PROCESS  count the calls of the function that compares two spheres
// OUTPUT   all pairs, the comparisons and the contacts; for the lesson, those
//          of the longest row
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_broadphase

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;

// #region count
// MuJoCo keeps one function for each pair of types, and takes another.
mjfCollision sphere_sphere = mjCOLLISIONFUNC[mjGEOM_SPHERE][mjGEOM_SPHERE];
int calls = 0;

int counting(const mjModel* model, const mjData* data, mjContact* contact,
             int geom1, int geom2, mjtNum margin) {
  ++calls;
  return sphere_sphere(model, data, contact, geom1, geom2, margin);
}
// #endregion

// `count` balls with a radius of 50 mm, `apart` (m) from centre to centre.
Model row(int count, double apart) {
  std::string mjcf = "<mujoco><size njmax='1000' nconmax='1000'/><worldbody>";
  for (int i = 0; i < count; ++i)
    mjcf += "<body pos='" + to_text(apart * i) +
            " 0 0'><joint type='slide'/><geom size='0.05' condim='1'/></body>";
  return load_model_xml(mjcf + "</worldbody></mujoco>");
}

int main() {
  mjCOLLISIONFUNC[mjGEOM_SPHERE][mjGEOM_SPHERE] = counting;
  std::printf("balls  apart (mm)  pairs  compared  contacts\n");
  for (const int count : {10, 100}) {
    for (const double apart : {0.15, 0.09, 0.03}) {
      const Model model = row(count, apart);
      const Data data = make_data(model);
      calls = 0;
      mj_kinematics(model, data);
      mj_collision(model, data);
      const int pairs = count * (count - 1) / 2;
      std::printf("%5d  %10.0f  %5d  %8d  %8d\n", count, 1000 * apart, pairs,
                  calls, data->ncon);
      if (count == 100 && apart == 0.09)
        result("pairs", pairs), result("compared", calls);
    }
  }
  mjCOLLISIONFUNC[mjGEOM_SPHERE][mjGEOM_SPHERE] = sphere_sphere;
}
