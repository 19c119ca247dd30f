// Lesson 0.2: what the compiler has made of a model's file.
//
// INPUT    scales.xml
// PROCESS  compile it, and print what is in the mjModel; write the model back
// OUTPUT   a range, places, rotations, sizes and a mass; what mj_saveLastXML
//          writes for the left side
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l0_2_compiled

#include <cstdio>
#include <fstream>
#include <mjcourse/mjcourse.hpp>
#include <string>

using namespace mjcourse;
using Eigen::Map, Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector4d;

void show_geom(const Model& model, const char* name) {
  const int geom = id_of(model, mjOBJ_GEOM, name);
  std::printf("%s\n", name);
  print("  geom_pos    ", Map<Vector3d>(model->geom_pos + 3 * geom));
  print("  geom_quat   ", Map<Vector4d>(model->geom_quat + 4 * geom));
  print("  geom_size   ", Map<Vector3d>(model->geom_size + 3 * geom));
}

void show_body(const Model& model, const char* name) {
  const int body = id_of(model, mjOBJ_BODY, name);
  const Vector3d inertia(model->body_inertia + 3 * body);
  std::printf("%s\n", name);
  print("  body_mass   ", model->body_mass[body]);
  print("  body_ipos   ", Map<Vector3d>(model->body_ipos + 3 * body));
  print("  body_iquat  ", Map<Vector4d>(model->body_iquat + 4 * body));
  std::printf("  body_inertia %s\n", to_text(inertia, 7).c_str());
}

// Lines of a saved model, from the one with `first` in it to its </body>.
void print_lines(const char* path, const std::string& first) {
  std::ifstream file(path);
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    inside = inside || line.find(first) != line.npos;
    if (inside) std::puts(line.substr(6).c_str());
    if (inside && line.find("</body>") != line.npos) return;
  }
}

int main() {
  const Model model = load_model("scales");
  const int tilt = id_of(model, mjOBJ_JOINT, "tilt");
  print("tilt, jnt_range", Map<Vector2d>(model->jnt_range + 2 * tilt));
  show_geom(model, "rod");
  show_geom(model, "box");
  show_body(model, "left");

  char error[1000] = "";
  if (mj_saveLastXML("saved.xml", model, error, sizeof error) == 0)
    throw std::runtime_error(error);
  std::puts("\nwritten back:");
  print_lines("saved.xml", "name=\"left\"");
}
