// What the page of a model tells, `[text](model:joint_zoo)`: a picture, sizes, joints, files.
// Tested by tests/generator/evaluate/scenes/model_lab_test.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "findings/result.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

struct ModelPage {
  // "qpos[7:11]" is {7, 4}.
  struct Range {
    int first = 0, count = 0;
  };
  struct Joint {
    std::string name, type, body;  // unnamed: "joint 3"
    Range qpos, dof;
    std::string limits;  // "−0.35 … 0.35 m"; empty for none
  };
  struct Actuator {
    std::string name, on;  // "joint slide"
    std::string limits;    // of its control; empty for none
  };
  struct Sensor {
    std::string name, of;  // "site imu"; may be empty
    Range data;
  };
  struct Keyframe {
    std::string name;
    std::string time;  // seconds
  };
  struct File {
    std::string path;  // below the course's folder: "models/joint_zoo.xml"
    std::string text;  // of MJCF; empty for meshes and the like
  };

  std::string name;
  std::vector<std::pair<std::string, int>> sizes;  // "nq", 13
  std::string timestep;                            // seconds
  std::vector<Joint> joints;
  std::vector<Actuator> actuators;
  std::vector<Sensor> sensors;
  std::vector<Keyframe> keyframes;
  std::vector<File> files;  // its own first, then those it is made of
  Poster poster;
  // A lab with this model (evaluate/scenes/model_lab.h).
  struct LiveLab {
    std::shared_ptr<const Lesson> lesson;  // whose one block it is (lesson/lesson_of_lab.h)
    LabResult result;                      // without a poster, which is the page's
  };
  std::optional<LiveLab> lab;  // nothing for a model that does not bear to be simulated
};

// What its poster shows, in words.
std::string alt_of(const ModelPage& page);

}  // namespace mjcourse
