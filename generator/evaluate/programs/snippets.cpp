#include "evaluate/programs/snippets.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "base/temporary_folder.h"
#include "evaluate/programs/compile_errors.h"
#include "evaluate/programs/compiled_recipe.h"
#include "evaluate/programs/judge_run.h"
#include "evaluate/programs/page_run.h"
#include "evaluate/programs/program_files.h"
#include "evaluate/programs/snippet_text.h"
#include "findings/snippet_program.h"
#include "physics/vetted_model.h"
#include "toolchain/containment.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrelude = R"(#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>
)";
// A course may do without it.
constexpr const char* kHelper = R"(
#include <mjcourse/mjcourse.hpp>
using namespace mjcourse;
)";

// What stands behind the last snippet.
constexpr const char* kMainFile = "main.cpp";
// Its arguments: the number of the snippet, and the model's file.
constexpr const char* kMain = R"(};
int main(int, char** arguments) {
  mju_user_error = [](const char* error) {
    std::fflush(stdout);
    std::fprintf(stderr, "MuJoCo error: %s\n", error);
    std::exit(70);
  };
  char error[1000] = "";
  mjModel* model = mj_loadXML(arguments[2], nullptr, error, sizeof error);
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  mjData* data = mj_makeData(model);
  snippets[std::atoi(arguments[1])](model, data);
  mj_deleteData(data);
  mj_deleteModel(model);
}
)";

struct Placed {
  std::size_t block;
  const Snippet* snippet;
  int line;  // of the fence
};

std::vector<Placed> snippets_of(const Lesson& lesson) {
  std::vector<Placed> all;
  for (std::size_t i = 0; i < lesson.blocks.size(); ++i) {
    if (const auto* snippet = std::get_if<Snippet>(&lesson.blocks[i])) {
      all.push_back({i, snippet, lesson.source->position(snippet->span.begin).line});
    }
  }
  return all;
}

// Each function opens on the line of its fence and closes on that of the fence's end, so every line
// of the program belongs to a snippet.
std::string program_text(const std::vector<Placed>& snippets, const Lesson& lesson,
                         const IncludeFolders& include) {
  std::string text = snippets_prelude(include);
  std::string table;
  for (std::size_t i = 0; i < snippets.size(); ++i) {
    const std::string name = "snippet_" + std::to_string(i);
    text += "#line " + std::to_string(snippets[i].line) + " \"" + lesson.source->path() +
            "\"\nstatic void " + name +
            "([[maybe_unused]] mjModel* model, [[maybe_unused]] mjData* data) {\n" +
            snippets[i].snippet->code.text + "}\n";
    table += name + ",\n";
  }
  return text + "#line 1 \"" + kMainFile +
         "\"\nstatic void (*const snippets[])(mjModel*, mjData*) = {\n" + table + kMain;
}

// The line of the lesson that messages[index] is about: its own, or where it speaks of a header,
// that of the first note behind it that names the lesson; 0 where there is none.
int lesson_line(const Compiled& compiled, std::size_t index, const std::string& lesson) {
  for (std::size_t i = index; i < compiled.messages.size(); ++i) {
    if (i > index && compiled.messages[i].severity != "note") break;
    if (compiled.messages[i].file == lesson) return compiled.messages[i].line;
  }
  return 0;
}

// The snippet that leaves a brace open, if one does: what comes behind it cannot begin.
const Placed* find_open(const Compiled& compiled, const std::vector<Placed>& snippets,
                        const std::string& lesson) {
  for (const CompilerMessage& message : compiled.messages) {
    if (message.severity != "error") continue;
    if (message.file == kMainFile) return &snippets.back();
    for (std::size_t i = 1; i < snippets.size(); ++i) {
      if (message.file == lesson && message.line == snippets[i].line) return &snippets[i - 1];
    }
  }
  return nullptr;
}

// Each message, with the notes behind it, is reported with the snippet that it is about.
void report_messages(const Compiled& compiled, const std::vector<Placed>& snippets,
                     const Lesson& lesson, const fs::path& root, Diagnostics& diagnostics) {
  if (const Placed* open = find_open(compiled, snippets, lesson.source->path())) {
    diagnostics.push_back(error_at(place_of(*lesson.source, open->snippet->span), "E-snippet-open",
                                   "this snippet leaves a brace or a parenthesis open",
                                   "close it; a line that begins with `//| ` is not shown"));
    return;
  }
  std::vector<Compiled> parts(snippets.size());
  std::size_t part = 0;
  for (std::size_t i = 0; i < compiled.messages.size(); ++i) {
    if (compiled.messages[i].severity != "note") {
      const int line = lesson_line(compiled, i, lesson.source->path());
      const auto after = std::find_if(snippets.begin(), snippets.end(),
                                      [&](const Placed& placed) { return placed.line > line; });
      part = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - snippets.begin()) - 1);
    }
    parts[part].messages.push_back(compiled.messages[i]);
  }
  const bool linker = !compiled.succeeded && !compiled.refused();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].succeeded = !linker || i > 0;
    parts[i].raw = compiled.raw;
    report_compile_messages(parts[i],
                            {snippets[i].snippet->code, snippets[i].line + 1, lesson.source->path(),
                             snippets[i].snippet->span},
                            lesson, root, diagnostics);
  }
}

// The file of a model that compiles; empty for another, which is reported where models are.
fs::path model_file(const Snippet& snippet, const Course& course, const fs::path& root) {
  const std::string& name = snippet.model.text;
  if (std::find(course.models.begin(), course.models.end(), name) == course.models.end()) return {};
  const fs::path path = fs::absolute(root / "models" / (name + ".xml"));
  return load_vetted_file(root, "models/" + name + ".xml") ? path : fs::path();
}

}  // namespace

std::string snippets_prelude(const IncludeFolders& include) {
  std::string text = kPrelude;
  if (!folder_with(kHelperHeader, include).empty()) text += kHelper;
  return text;
}

std::map<std::size_t, ExampleResult> evaluate_snippets(const Lesson& lesson,
                                                       WorkerContext& worker_context,
                                                       Diagnostics& diagnostics) {
  const std::vector<Placed> snippets = snippets_of(lesson);
  const fs::path& root = worker_context.root();
  const std::optional<Compiler>& compiler = worker_context.run_context().compiler();
  std::optional<Diagnostic> why = worker_context.run_context().why_nothing_runs();
  if (!why && !compiler) why = no_compiler();
  if (why) {
    diagnostics.push_back(*std::move(why));
    diagnostics.back().place = place_of(*lesson.source, snippets.front().snippet->span);
    return {};
  }
  const TemporaryFolder folder;
  const fs::path source = folder.path() / "snippets.cpp", binary = folder.path() / "snippets";
  write_file(source,
             program_text(snippets, lesson, worker_context.run_context().include_folders()));
  const Compiled compiled = compiler->compile(source, binary, folder.path());
  trace_compilation(compiled, source, worker_context);
  report_messages(compiled, snippets, lesson, root, diagnostics);
  const std::string prelude = snippets_prelude(worker_context.run_context().include_folders());
  std::map<std::size_t, ExampleResult> results;
  if (!compiled.succeeded) return results;
  for (std::size_t i = 0; i < snippets.size(); ++i) {
    const Snippet& snippet = *snippets[i].snippet;
    const fs::path model = model_file(snippet, worker_context.course(), root);
    if (model.empty()) continue;
    Command command;
    command.arguments = {binary.string(), std::to_string(i), model.string()};
    command.folder = folder.path() / ("run-" + std::to_string(i));
    fs::create_directory(command.folder);
    command.environment = {"MJCOURSE_MODELS=" + fs::absolute(root / "models").string()};
    command.seconds = snippet.seconds;
    command.sandbox = program_sandbox(binary, command.folder, {}, root);
    command.record_opened = true;
    const Stopwatch stopwatch;
    Outcome outcome = run(command);
    const double seconds = stopwatch.seconds();
    trace_run(outcome, folder.path(), worker_context);
    if (auto wrong = judge_run(outcome, {"snippet", snippet.seconds})) {
      wrong->place = place_of(*lesson.source, snippet.span);
      diagnostics.push_back(*std::move(wrong));
    } else {
      ExampleResult& result = results[snippets[i].block];
      std::vector<std::string> files =
          program_files(compiled, outcome, worker_context.run_context());
      result = {
          snippet_text(snippet, prelude), std::move(outcome.out), {}, seconds, std::move(files)};
      result.page = run_in_page(snippet_program(lesson, snippets[i].block), result.code, result,
                                worker_context);
    }
  }
  return results;
}

}  // namespace mjcourse
