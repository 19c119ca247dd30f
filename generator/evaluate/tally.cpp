#include "evaluate/result.h"

namespace mjcourse {

Tally& Tally::operator+=(const Tally& other) {
  formulas += other.formulas;
  programs += other.programs;
  outputs += other.outputs;
  values += other.values;
  answers_proved += other.answers_proved;
  answers_asserted += other.answers_asserted;
  labs += other.labs;
  pictures += other.pictures;
  return *this;
}

}  // namespace mjcourse
