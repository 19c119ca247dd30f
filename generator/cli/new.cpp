// `mjcourse new KIND NAME`. Steps: find the kind; ask it for the files (new_part.h); write all of
// them, or none; say which.
// Tested by tests/generator/cli/new_part_test.cpp.
#include <iostream>

#include "base/beneath.h"
#include "base/nearest.h"
#include "cli/commands.h"
#include "cli/course_file.h"
#include "cli/new_part.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "process/our_command.h"

namespace mjcourse {

NewPartOrRefusal new_part(const Files& course, const Files& assets,
                          const std::vector<std::string>& words) {
  const std::vector<std::string> kinds{"level", "lesson", "model", "example", "exercise", "ci"};
  if (words.empty()) {
    return wrong_words("new what?",
                       "a level, a lesson, a model, an example, an exercise or a ci, as in " +
                           our_command("new lesson 2-dynamics \"Forces\""));
  }
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (words[0] == "level") return new_level(course, rest);
  if (words[0] == "lesson") return new_lesson(course, assets, rest);
  if (words[0] == "ci") return new_ci(assets, rest);
  if (words[0] == "model") return new_model(assets, rest);
  if (words[0] == "exercise") return new_exercise(course, assets, rest);
  if (words[0] == "example") return new_example(course, assets, rest);
  return wrong_words("new cannot make `" + words[0] + "`", suggest(words[0], kinds));
}

int make_new(const NewOptions& options) {
  const DiskFiles course(options.course);
  const auto part = new_part(course, DiskFiles(assets_folder()), options.words);
  if (!part) return tell(part.error());
  // A model in a folder that is no course would be lost there.
  if (const auto yaml = course.read(kCoursePath); !yaml) return tell(no_course(yaml.error()));
  if (const auto good = check_length(part->folder); !good) return tell(good.error());
  if (const auto written = write_new_files(options.course, part->files); !written) {
    return tell(written.error());
  }
  if (!part->folder.empty()) {
    const std::string inside = part->folder + "/.";  // so that it is made itself
    const auto made = Beneath(options.course).spot(inside, Beneath::Missing::is_made);
    if (!made && made.error().is_refused()) throw_unopened(part->folder, made.error());
  }
  tell(part->files);
  std::cout << part->next << '\n';
  return kClean;
}

}  // namespace mjcourse
