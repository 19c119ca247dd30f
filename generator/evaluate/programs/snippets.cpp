#include "evaluate/programs/snippets.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/programs/compile_errors.h"
#include "evaluate/programs/judge_run.h"
#include "evaluate/programs/snippet_text.h"
#include "physics/vetted_model.h"

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
// Its arguments: the number of the snippet, and the model.
constexpr const char* kMain = R"(};
int main(int, char** arguments) {
  mju_user_error = [](const char* error) {
    std::fflush(stdout);
    std::fprintf(stderr, "MuJoCo error: %s\n", error);
    std::exit(70);
  };
  const std::string file = std::string(std::getenv("MJCOURSE_MODELS")) + "/" + arguments[2] + ".xml";
  char error[1000] = "";
  mjModel* model = mj_loadXML(file.c_str(), nullptr, error, sizeof error);
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
                            {snippets[i].snippet->code, lesson.source->path(),
                             snippets[i].snippet->span, snippets[i].line + 1},
                            lesson, root, diagnostics);
  }
}

// Does the snippet's model? One that does not is reported where models are.
bool compiles(const Snippet& snippet, const WorkerContext& worker_context) {
  const std::string& name = snippet.model.text;
  const std::vector<std::string>& models = worker_context.course().models;
  return std::ranges::find(models, name) != models.end() &&
         load_vetted_file(worker_context.root(), "models/" + name + ".xml").has_value();
}

NativeRequest request_of(std::size_t index, const Snippet& snippet) {
  return {{std::to_string(index), snippet.model.text}, snippet.seconds};
}

NativeProgram program_of(const std::vector<Placed>& snippets, const Lesson& lesson,
                         WorkerContext& worker_context) {
  const IncludeFolders include = worker_context.run_context().include_folders();
  return NativeProgram({"snippets", "snippets.cpp", program_text(snippets, lesson, include)},
                       worker_context.action_context());
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
  const RunContext& run_context = worker_context.run_context();
  std::optional<Diagnostic> why = run_context.why_nothing_runs();
  if (!why && !run_context.compiler()) why = no_compiler();
  if (why) {
    diagnostics.push_back(*std::move(why));
    diagnostics.back().place = place_of(*lesson.source, snippets.front().snippet->span);
    return {};
  }
  NativeProgram program = program_of(snippets, lesson, worker_context);
  std::vector<std::optional<NativeRun>> known;
  for (const Placed& placed : snippets) {
    known.push_back(compiles(*placed.snippet, worker_context)
                        ? program.find(request_of(known.size(), *placed.snippet))
                        : std::nullopt);
  }
  if (!std::ranges::all_of(known, [](const auto& run) { return run.has_value(); })) {
    const Compiled& compiled = program.compile();
    report_messages(compiled, snippets, lesson, worker_context.root(), diagnostics);
    if (!compiled.succeeded) return {};
  }
  const std::string prelude = snippets_prelude(run_context.include_folders());
  std::map<std::size_t, ExampleResult> results;
  for (std::size_t i = 0; i < snippets.size(); ++i) {
    const Snippet& snippet = *snippets[i].snippet;
    std::optional<NativeRun>& run = known[i];
    if (!run && !compiles(snippet, worker_context)) continue;
    if (!run) run = program.run(request_of(i, snippet));
    if (auto wrong = judge_run(run->outcome, {"snippet", snippet.seconds})) {
      wrong->place = place_of(*lesson.source, snippet.span);
      diagnostics.push_back(*std::move(wrong));
    } else {
      results[snippets[i].block] = {snippet_text(snippet, prelude),
                                    std::move(run->outcome.out),
                                    {},
                                    run->seconds,
                                    std::move(run->files)};
    }
  }
  return results;
}

bool are_known(const Lesson& lesson, WorkerContext& worker_context) {
  if (!worker_context.run_context().compiler()) return false;
  const std::vector<Placed> snippets = snippets_of(lesson);
  return program_of(snippets, lesson, worker_context)
      .find(request_of(0, *snippets.front().snippet))
      .has_value();
}

}  // namespace mjcourse
