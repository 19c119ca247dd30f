// BoundedTables: while it lives, the tables that cmark reads on this thread end at kMostCells
// (lesson/syntax/markdown.h), and what they lose is known.
// Tested by tests/generator/lesson/bounds_test.cpp.
#pragma once

#include "lesson/syntax/loss.h"

namespace mjcourse {

class BoundedTables {
 public:
  // Make cmark's tables ask. Once, before any is read.
  static void teach();

  explicit BoundedTables(Losses& losses);
  BoundedTables(const BoundedTables&) = delete;
  BoundedTables& operator=(const BoundedTables&) = delete;
  ~BoundedTables();

  // The line at which a row or a whole table was left out; 0 for none.
  int refused_line() const;
};

}  // namespace mjcourse
