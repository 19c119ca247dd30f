#include "evaluate/programs/exercise_files.h"

#include <utility>

#include "base/files.h"
#include "report/refused_file.h"

namespace mjcourse {
namespace {

std::optional<std::string> read_program(const LocatedText& path, const std::string& cure,
                                        const Lesson& lesson, WorkerContext& worker_context,
                                        Diagnostics& diagnostics) {
  const DiskFiles files(worker_context.root());
  const Place place = place_of(*lesson.source, path.span());
  if (const auto refusal = files.refusal(path.text)) {
    diagnostics.push_back(refused_file(place, path.text, *refusal));
    return std::nullopt;
  }
  auto text = files.read(path.text);
  if (text) return *std::move(text);
  diagnostics.push_back(error_at(place, "E-example-file", "cannot read " + text.error(), cure));
  return std::nullopt;
}

}  // namespace

std::optional<ExerciseFiles> read_exercise_files(const Exercise& exercise, const Lesson& lesson,
                                                 WorkerContext& worker_context,
                                                 Diagnostics& diagnostics) {
  const LocatedText& path = exercise.program.file;
  const std::string& region = exercise.program.region->text;
  const auto program = read_program(path, "write it: the fence is empty, so its text is the file's",
                                    lesson, worker_context, diagnostics);
  if (!program) return std::nullopt;
  const std::string& first =
      worker_context.run_context().shown().at(path.text).exercises.front()->program.region->text;
  if (first != region) {
    diagnostics.push_back(error_at(place_of(*lesson.source, exercise.program.region->span()),
                                   "E-exercise-text",
                                   path.text + " is the exercise of its region `" + first + "`",
                                   "write a program of its own for another"));
    return std::nullopt;
  }
  const std::size_t before = diagnostics.size();
  const auto text = read_exercise(SourceText(path.text, *program), region, diagnostics);
  for (std::size_t i = before; i < diagnostics.size(); ++i) {
    diagnostics[i].notes.push_back(
        {"the lesson has this exercise", place_of(*lesson.source, exercise.span)});
  }
  if (!text) return std::nullopt;
  ExerciseFiles files{*text, std::nullopt};
  if (!exercise.hidden) return files;
  files.hidden =
      read_program(*exercise.hidden, "write it, with an empty region `" + region + "` and checks",
                   lesson, worker_context, diagnostics);
  if (!files.hidden) return std::nullopt;
  const auto inside = code_in_region(*files.hidden, region);
  if (inside && inside->find_first_not_of(" \t\r\n") == inside->npos) return files;
  diagnostics.push_back(
      error_at(place_of(*lesson.source, exercise.hidden->span()), "E-exercise-text",
               exercise.hidden->text + " " +
                   (inside ? "has code in the region `" + region + "`" : inside.error()),
               "leave `// #region " + region +
                   "` and `// #endregion` there with nothing between them: what "
                   "the reader writes comes there"));
  return std::nullopt;
}

Example hidden_program(const Exercise& exercise) {
  Example program = exercise.program;
  program.quoted = false;  // the lesson quotes the solution's
  program.file = *exercise.hidden;
  program.native = "no page has its checks";
  return program;
}

std::string hidden_text(const Exercise& exercise, const ExerciseFiles& files,
                        const std::string& code) {
  return with_code_in_region(*files.hidden, exercise.program.region->text, code,
                             exercise.hidden->text)
      .value();
}

}  // namespace mjcourse
