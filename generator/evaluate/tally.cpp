#include "evaluate/result.h"

namespace mjcourse {

Tally& Tally::operator+=(const Tally& other) {
  formulas += other.formulas;
  programs += other.programs;
  snippets += other.snippets;
  outputs += other.outputs;
  values += other.values;
  listed_models += other.listed_models;
  unchecked += other.unchecked;
  answers_proved += other.answers_proved;
  answers_asserted += other.answers_asserted;
  labs += other.labs;
  pictures += other.pictures;
  plots += other.plots;
  return *this;
}

}  // namespace mjcourse
