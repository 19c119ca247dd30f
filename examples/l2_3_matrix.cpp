// Lesson 2.3: which geoms of a model may touch which.
//
// INPUT    two_stands.xml, in its key "side"
// PROCESS  let every contact begin 10 m before the touch, so that each pair
//          that nothing rules out is in the list; then look what touches
// OUTPUT   a matrix of the geoms that take part in collisions: o for pairs that
//          may touch, X for those that do
//
// Run: cmake -S examples -B build && cmake --build build
//      build/l2_3_matrix

#include <cstdio>
#include <mjcourse/mjcourse.hpp>
#include <vector>

using namespace mjcourse;
using Matrix = Eigen::MatrixXi;  // geoms x geoms, 1 where two touch

Matrix contacts_of(const Model& model, const Data& data) {
  Matrix found = Matrix::Zero(model->ngeom, model->ngeom);
  mj_forward(model, data);
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    found(contact.geom1, contact.geom2) = 1;
    found(contact.geom2, contact.geom1) = 1;
  }
  return found;
}

// Every pair that no rule leaves out is within 10 m of a touch.
Matrix may_touch(const Model& model) {
  for (int geom = 0; geom < model->ngeom; ++geom)
    model->geom_margin[geom] = model->geom_gap[geom] = 10;
  const Matrix found = contacts_of(model, make_data(model));
  for (int geom = 0; geom < model->ngeom; ++geom)
    model->geom_margin[geom] = model->geom_gap[geom] = 0;
  return found;
}

int main() {
  const Model model = load_model("two_stands");
  const Matrix may = may_touch(model);
  const Data data = make_data(model);
  mj_resetDataKeyframe(model, data, id_of(model, mjOBJ_KEY, "side"));
  const Matrix touch = contacts_of(model, data);
  std::vector<int> takes_part;
  for (int geom = 0; geom < model->ngeom; ++geom)
    if (may.row(geom).any()) takes_part.push_back(geom);
  for (const int row : takes_part) {
    std::printf("%-12s", mj_id2name(model, mjOBJ_GEOM, row));
    for (const int column : takes_part)
      std::printf("  %c", touch(row, column) ? 'X'
                          : may(row, column) ? 'o'
                                             : '.');
    std::printf("\n");
  }
  result("pairs", may.sum() / 2);
  result("touching", touch.sum() / 2);
}
