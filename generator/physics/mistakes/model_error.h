// Why a model did not load, as a place and one line of text.
//
// MuJoCo answers with up to three lines in one of several shapes, each with its own spelling of the
// line number. explain_load_error() knows them all.
#pragma once

#include <string>

namespace mjcourse {

struct ModelError {
  std::string file;     // the file at fault, which may be an included one; "" for text
  int line = 0;         // from 1; 0 where MuJoCo does not know
  int column = 0;       // from 1; 0 where MuJoCo does not know
  std::string message;  // one line, without MuJoCo's preamble
  std::string cure{};   // "did you mean `size`?"; "" when there is nothing to suggest
};

// The error that `answer`, mj_loadXML's error buffer, speaks of. `file` is the path that was
// loaded, or "" for text; `mjcf` is its content, which is asked for the name of an include at
// fault. MuJoCo keeps no line of an element that came from an include, and knows none of a
// keyframe: lost_line.h finds these.
ModelError explain_load_error(const std::string& answer, const std::string& file,
                              const std::string& mjcf = "");

}  // namespace mjcourse
