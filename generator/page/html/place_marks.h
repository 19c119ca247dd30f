// PlaceMarks: comments in a lesson's page that say of which lines it is made.
//
// For the preview of a page while it is being written: `<!--lines 12-15-->` before each part of the
// text, `<!--lines 12-15 running-->` where a result in it is a stand-in, and kEndOfPlaces behind
// the last. A site has none of them.
#pragma once

#include <vector>

#include "findings/lesson_results.h"
#include "lesson/blocks/lesson.h"

namespace mjcourse {

inline constexpr const char* kEndOfPlaces = "<!--lines-->\n";

// While this lives, the lesson's document has the comments.
class PlaceMarks {
 public:
  PlaceMarks(const Lesson& lesson, const LessonResults& results);
  ~PlaceMarks();
  PlaceMarks(const PlaceMarks&) = delete;
  PlaceMarks& operator=(const PlaceMarks&) = delete;

 private:
  std::vector<Document> marks_;  // in the tree, and ours
};

}  // namespace mjcourse
