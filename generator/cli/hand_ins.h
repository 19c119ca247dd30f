// What was handed in: a folder for each student, with a file for each exercise.
//
// It may hold anything. So nothing in it ends the work: what is no hand-in is told in a note, and
// what stands in the way of one becomes its remark. Links are not followed, for one could lead to
// the work of somebody else.
// Enter at find_hand_ins().
// Tested by tests/generator/cli/hand_ins_test.cpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mjcourse {

struct HandIn {
  std::string student;           // the folder's name; its path where two have the same name
  std::filesystem::path folder;  // as it was named
  std::string fault = {};        // why nothing of it is read
};

struct HandIns {
  std::vector<HandIn> all;         // in their order
  std::vector<std::string> notes;  // of what is none, of students who are there twice
};

// `words` are paths. Those where nothing is, are left out, with a note.
HandIns find_hand_ins(const std::vector<std::string>& words);

// The file of one exercise; neither a text nor a fault where it was not handed in.
struct HandedIn {
  std::optional<std::string> text = {};  // its lines end with line feeds
  std::string fault = {};                // why it is not read
  std::optional<std::chrono::sys_seconds> changed = {};

  bool is_there() const { return text || !fault.empty(); }
};

// NAME.cpp, or NAME/NAME.cpp, for the exercise `name`.
HandedIn read_handed_in(const HandIn& hand_in, const std::string& name);

// What else is in the folder and may be meant for one of the exercises `names` that was not handed
// in; that the folder is empty; and what is there where none of them is.
std::vector<std::string> notes_on(const HandIn& hand_in, const std::vector<std::string>& names);

}  // namespace mjcourse
