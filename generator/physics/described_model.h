// Models that exist only as a description: "two hinges and a free joint".
//
// A question such as "what is nq of a robot with …" is proved by building that robot and asking
// MuJoCo, not by a formula of ours.
#pragma once

#include <string>

namespace mjcourse {

// How many joints of each of MuJoCo's types; none negative.
struct DescribedJoints {
  int hinge = 0;
  int slide = 0;
  int ball = 0;
  int free = 0;
};

// MJCF of a model with just those joints, each in a body of its own under the world, free joints
// first, then ball, slide, hinge; named by their type and number: "ball0".
std::string described_mjcf(const DescribedJoints& joints);

}  // namespace mjcourse
