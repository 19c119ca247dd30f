// BoundedTables: while it lives, the tables that cmark reads on this thread end at kMostCells
// (lesson/markdown.h).
#pragma once

namespace mjcourse {

class BoundedTables {
 public:
  // Make cmark's tables ask. Once, before any is read.
  static void teach();

  BoundedTables();

  // The line at which a row or a whole table was left out; 0 for none.
  int refused_line() const;
};

}  // namespace mjcourse
