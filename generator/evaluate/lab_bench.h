// The bench that a lab is rehearsed on.
#pragma once

#include "evaluate/bench.h"

namespace mjcourse {

class LabBench : public Bench {
 public:
  LabBench(const Lab& lab, const Lesson& lesson, Workshop& workshop, Diagnostics& diagnostics)
      : Bench(lesson, workshop, diagnostics), lab_(lab) {}

  const Lab& lab() const { return lab_; }

 private:
  const Lab& lab_;
};

}  // namespace mjcourse
