// What `mjcourse new` makes: a level, a lesson, a model, an example, an exercise or a CI's file, as
// the files to write.
//
// Enter at new_part. Nothing here writes; the course is only looked at, and a course with mistakes
// in its lessons is as good as another.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/files.h"
#include "cli/new_files.h"

namespace mjcourse {

struct NewPart {
  std::vector<NewFile> files;  // course.yaml last, where it changes
  std::string folder = {};     // of a level, which is empty as yet
  std::string next;            // what its author may do now
};

using NewPartOrRefusal = tl::expected<NewPart, Refusal>;

// `words` is the kind and what stands behind it on the command line.
NewPartOrRefusal new_part(const Files& course, const Files& assets,
                          const std::vector<std::string>& words);

// Each kind, of the words behind it.
NewPartOrRefusal new_level(const Files& course, const std::vector<std::string>& words);
NewPartOrRefusal new_lesson(const Files& course, const Files& assets,
                            const std::vector<std::string>& words);
NewPartOrRefusal new_model(const Files& assets, const std::vector<std::string>& words);
NewPartOrRefusal new_exercise(const Files& course, const Files& assets,
                              const std::vector<std::string>& words);
NewPartOrRefusal new_example(const Files& course, const Files& assets,
                             const std::vector<std::string>& words);

NewPartOrRefusal new_ci(const Files& assets, const std::vector<std::string>& words);

}  // namespace mjcourse
