// What is wrong with a script, before the caller knows where in a lesson that script stands.
//
// Lines and columns are within the author's own text, wrapper and bundle left out, so a caller adds
// the place of the text in the lesson and has a Diagnostic.
//
//   E-script-syntax  not JavaScript
//   E-script-name    a field, body, joint, function … that does not exist
//   E-script-range   an index past the end, an array of the wrong length
//   E-script-value   a write that is not a finite number; a result of the wrong type
//   E-script-time    an endless loop
//   E-script-foreign what a lab's script could reach the reader's page with
//   E-script-mujoco  MuJoCo refused, warned or diverged
//   E-script-throw   any other exception
#pragma once

#include <string>

namespace mjcourse {

struct ScriptError {
  std::string id;
  std::string message;
  std::string cure;       // empty when there is nothing to suggest
  int line = 0;           // from 1; 0 when the place is not known
  int column = 0;         // from 1, in characters; 0 when the place is not known
  int width = 1;          // characters to underline
  bool in_value = false;  // of a Program: the place is in its value, not in its run
};

}  // namespace mjcourse
