// `mjcourse try LESSON [EXERCISE]`: an exercise in a folder of its own, judged after each save.
//
// Steps: find the exercise; run its solution, which tells what checks there are and which files are
// needed; write what is not there yet; judge the text, and again whenever it was saved, until all
// checks hold.
// Tested by tests/system/try.mjs.
#include <algorithm>
#include <iostream>
#include <stop_token>
#include <string>
#include <utility>

#include "base/beneath.h"
#include "base/counted.h"
#include "base/out_folder.h"
#include "base/text_lines.h"
#include "base/utf8.h"
#include "cli/commands.h"
#include "cli/exercise_list.h"
#include "cli/run.h"
#include "cli/verify.h"
#include "evaluate/hand_in.h"
#include "evaluate/versions.h"
#include "lesson/syntax/exercise_text.h"
#include "page/program_folder.h"
#include "process/subprocess.h"
#include "session/folder_watch.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

std::string without_returns(std::string text) {
  std::erase(text, '\r');
  return text;
}

constexpr std::size_t kMostShown = 30;  // lines

// The first lines of what a program printed, set apart.
std::string shown(const std::string& output) {
  std::string text;
  const std::vector<std::string_view> lines = lines_of(output);
  for (std::size_t i = 0; i < std::min(lines.size(), kMostShown); ++i) {
    text += "  | " + readable(std::string(lines[i])) + "\n";
  }
  if (lines.size() > kMostShown) {
    text += "  and " + std::to_string(lines.size() - kMostShown) + " lines more\n";
  }
  return text;
}

class Trying {
 public:
  Trying(const ListedExercise& listed, const JudgedExercise& judged, const ExerciseJudge& judge,
         fs::path folder)
      : listed_(listed), judged_(judged), judge_(judge), folder_(std::move(folder)) {}

  // What is there stays as it is. Nothing is written where one of the files is a link: a reader who
  // was told to write in there would write into what it leads to.
  void write_missing(const SiteData& site, const OutFolder& folder) const {
    const ExampleResult taken{"", "", {}, 0, judged_.sources, {}};
    const ExerciseText& text = judged_.files.text;
    const auto files = program_folder(
        {judged_.exercise->program, taken, *judged_.lesson, text.program(text.starter().code)},
        site);
    std::vector<std::pair<std::string, std::string_view>> missing;
    for (const auto& [path, bytes] : files) {
      std::string inside = path.substr(path.find('/') + 1);
      if (!folder.holds_file(inside)) missing.emplace_back(std::move(inside), bytes);
    }
    for (const auto& [inside, bytes] : missing) folder.write(inside, bytes);
  }

  void tell_what_to_do() const {
    std::cout << listed_.name << ", lesson " << listed_.lesson->number
              << (listed_.title.empty() ? "" : ": " + listed_.title) << '\n'
              << "write what stands between `// #region " << judged_.exercise->program.region->text
              << "` and `// #endregion` in\n  " << file().string() << "\n\n"
              << std::flush;
  }

  // Does it hold now?
  bool judge_and_tell() const {
    const std::string path = file().string();
    const auto text = DiskFiles(folder_).read(listed_.name + ".cpp");
    if (!text) {
      std::cout << "cannot read " << text.error() << "\n\n" << std::flush;
      return false;
    }
    const auto code = code_in_region(*text, judged_.exercise->program.region->text);
    if (!code) {
      std::cout << path << " " << code.error() << "\n\n" << std::flush;
      return false;
    }
    if (judged_.files.text.program(*code) != without_returns(*text)) {
      std::cout << "note: what you changed outside of the region does not count here\n";
    }
    const Verdict verdict = judge_.judge(judged_, *code, path, false);
    tell(verdict);
    return verdict.holds();
  }

 private:
  fs::path file() const { return folder_ / (listed_.name + ".cpp"); }

  static void tell(const Verdict& verdict) {
    if (!verdict.output.empty()) std::cout << "it printed\n" << shown(verdict.output) << '\n';
    print_diagnostics(verdict.faults);
    std::string failing, holding;
    int held = 0;
    for (const Check& check : verdict.shown) {
      (check.holds ? holding : failing) += check_text(check);
      held += check.holds ? 1 : 0;
    }
    std::cout << failing << holding << held << " of " << counted(verdict.shown.size(), "check")
              << (held == 1 ? " holds" : " hold") << (verdict.holds() ? ": solved\n" : "\n\n")
              << std::flush;
  }

  const ListedExercise& listed_;
  const JudgedExercise& judged_;
  const ExerciseJudge& judge_;
  fs::path folder_;
};

void open_editor(const fs::path& file) {
  Command command;
  command.arguments = {"xdg-open", file.string()};
  command.folder = "/";
  const Outcome outcome = run(command);
  if (outcome.end == Outcome::End::exited && outcome.code == 0) return;
  std::cerr << "no editor could be opened (xdg-open, of the package xdg-utils, does that)\n";
}

Refusal link_in_the_way(std::string message) {
  return {kCourseErrors, std::move(message), "remove it, or name another folder: `--out DIR`"};
}

}  // namespace

int try_exercise(const TryOptions& options) {
  const Verified verified = read_course_of(options);
  if (!verified.course) {
    print_diagnostics(verified.evaluation.diagnostics);
    return kCourseErrors;
  }
  const Course& course = *verified.course;
  const auto listed = find_exercise(course, options.course, options.words);
  if (!listed) return tell(listed.error());
  const fs::path folder =
      fs::absolute(options.folder.empty() ? fs::path(listed->name) : options.folder)
          .lexically_normal();
  // One that the reader has named may be a link; this one may be a stranger's.
  if (options.folder.empty() && fs::is_symlink(folder)) {
    return tell(link_in_the_way(folder.string() + " is a link, so nothing is written there"));
  }
  const DiskFiles assets(assets_folder()), files(options.course);
  JudgeKey key = JudgeKey::random();
  key.seed = "";  // as the page has it
  const ExerciseJudge judge(course, evaluation_settings(options, assets, verified.store.get()),
                            key);
  Diagnostics diagnostics;
  if (auto why = judge.why_nothing_runs()) diagnostics.push_back(*std::move(why));
  const auto judged = diagnostics.empty()
                          ? judge.prepare(*listed->lesson, *listed->exercise, 1, diagnostics)
                          : std::nullopt;
  if (!judged) {
    print_diagnostics(diagnostics);
    return kCourseErrors;
  }
  const Trying trying(*listed, *judged, judge, folder);
  Evaluation evaluation;
  evaluation.versions = known_versions(assets);
  try {
    const OutPlace place = open_out_place(folder, options.course);
    trying.write_missing({course, evaluation, files, assets, {}, {}},
                         place.folder.inner(place.name));
  } catch (const RefusedPath& refused) {
    return tell(link_in_the_way(refused.what()));
  }
  trying.tell_what_to_do();
  if (options.open) open_editor(folder / (listed->name + ".cpp"));
  if (options.once) return trying.judge_and_tell() ? kClean : kCourseErrors;
  FolderWatch watch({folder});
  while (!trying.judge_and_tell()) {
    std::cout << "the next save is judged again (Ctrl-C ends it)\n" << std::flush;
    watch.wait({});
  }
  return kClean;
}

}  // namespace mjcourse
