#include "physics/described_model.h"

namespace mjcourse {
namespace {

// `count` bodies in a row along y, each free to move by one joint of type `type`.
std::string bodies(const std::string& type, int count, int row) {
  std::string mjcf;
  for (int i = 0; i < count; ++i) {
    mjcf += "    <body pos=\"" + std::to_string(row) + ' ' + std::to_string(i) + " 0\">";
    mjcf += "<joint name=\"" + type + std::to_string(i) + "\" type=\"" + type + "\"/>";
    mjcf += "<geom type=\"sphere\" size=\"0.1\"/></body>\n";
  }
  return mjcf;
}

}  // namespace

std::string described_mjcf(const DescribedJoints& joints) {
  return "<mujoco model=\"described\">\n  <worldbody>\n" + bodies("free", joints.free, 0) +
         bodies("ball", joints.ball, 1) + bodies("slide", joints.slide, 2) +
         bodies("hinge", joints.hinge, 3) + "  </worldbody>\n</mujoco>\n";
}

}  // namespace mjcourse
