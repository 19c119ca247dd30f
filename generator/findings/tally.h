// Tally: how much of a lesson, or of a course, was verified.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#pragma once

#include "findings/claim.h"

namespace mjcourse {

// How much was verified; what failed is not counted. The claims in numbers: see tally_of.
struct Tally {
  int formulas = 0;
  int programs = 0;
  int in_page = 0;  // of the programs
  int exercises = 0;
  int snippets = 0;
  int commands = 0;  // listings of them
  int outputs = 0;
  int values = 0;
  int listed_models = 0;
  int unchecked = 0;
  int answers_proved = 0;
  int answers_asserted = 0;
  int labs = 0;
  int pictures = 0;
  int plots = 0;

  Tally& operator+=(const Tally& other);
};

Tally tally_of(const Claims& claims);

}  // namespace mjcourse
