#include "evaluate/claims/code_claims.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "evaluate/claims/claim_text.h"

namespace mjcourse {
namespace {

using Kind = Claim::Kind;
using Status = Claim::Status;

std::string text_of(const Records& records) {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [name, value] : records.results) {
    nlohmann::json& result = all["results"][name];
    std::visit([&](const auto& known) { result = known; }, value);
  }
  for (const auto& [name, columns] : records.tables) {
    for (const Column& column : columns) all["tables"][name][column.name] = column.values;
  }
  all["snapshots"] = records.snapshots;
  return all.dump();
}

std::string text_of(const ExerciseResult& result) {
  nlohmann::json all = nlohmann::json::object();
  for (const ExerciseResult::Trial& trial : result.trials) all["fails"][trial.name] = trial.fails;
  for (const Check& check : result.checks) all["checks"].push_back(check.what);
  all["hidden"] = result.hidden;
  return all.dump();
}

// The first line of `code` that says something.
std::string first_line(const std::string& code) {
  const std::size_t begin = std::min(code.find_first_not_of(" \t\n"), code.size());
  return as_title(code.substr(begin, code.find('\n', begin) - begin));
}

// What printed an output.
std::string printer(const Block& block) {
  if (const auto* example = std::get_if<Example>(&block)) return example->name() + ".cpp";
  return std::holds_alternative<Commands>(block) ? "the commands above it" : "the snippet above it";
}

void claim_program(const Example& example, std::size_t i, const ExampleResult* result, Span extent,
                   ClaimContext& context) {
  Claim made = context.begin(Kind::program, i, example.file.text, extent);
  made.how = how_run(example, context.versions());
  if (example.compiles) made.limits = limits_of_run(example.seconds);
  if (result == nullptr) return context.finish(std::move(made), false, {example.code.text});
  made.run_seconds = result->run_seconds;
  context.finish(std::move(made), true,
                 {result->code, result->output, text_of(result->records),
                  context.versions().compiler, context.programs_sources(result->code)});
}

void claim_in_page(const std::string& title, std::size_t i, const ExampleResult* result,
                   Span extent, ClaimContext& context) {
  if (result == nullptr || !result->page) return;
  Claim made = context.begin(Kind::page, i, title + " in the page", extent);
  made.seconds = 0;  // of the program's
  made.reason = result->page->why_not;
  if (made.reason.empty()) {
    made.how = how_run_in_page();
  } else {
    made.status = Status::unchecked;
  }
  context.finish(std::move(made), true,
                 {result->code, result->output, context.versions().page,
                  context.programs_sources(result->code)});
}

}  // namespace

void claim(const Example& example, std::size_t i, ClaimContext& context) {
  const Span extent = context.fence(example.span);
  const auto program = context.programs.find(example.file.text);
  const ExampleResult* whole = program == context.programs.end() ? nullptr : &program->second;
  // An error inside the fence is the region's own; of the program's there, none would be left.
  const Span of_program = example.region ? Span{extent.begin, extent.begin} : extent;
  if (!example.region || context.stands.contains({context.index, i})) {
    claim_program(example, i, whole, of_program, context);
    claim_in_page(example.file.text, i, whole, of_program, context);
  }
  if (!example.region) return;
  Claim made =
      context.begin(Kind::region, i, example.file.text + "#" + example.region->text, extent);
  made.how = "compared with these lines of " + example.file.text + ", which was compiled and run";
  made.limits = "indentation does not count";
  made.seconds = 0;
  const auto* result = context.results.get<ExampleResult>(i);
  context.finish(std::move(made), result != nullptr,
                 {result == nullptr ? "" : result->code, whole == nullptr ? "" : whole->code});
}

void claim(const Exercise& exercise, std::size_t i, ClaimContext& context) {
  const Span extent = context.fence(exercise.span);
  const std::string& file = exercise.program.file.text;
  const auto program = context.programs.find(file);
  const ExampleResult* solution = program == context.programs.end() ? nullptr : &program->second;
  if (context.stands.contains({context.index, i})) {
    const Span of_program{extent.begin, extent.begin};
    claim_program(exercise.program, i, solution, of_program, context);
    claim_in_page(file, i, solution, of_program, context);
  }
  Claim made = context.begin(Kind::exercise, i, file + "#" + exercise.program.region->text, extent);
  made.limits = limits_of_run(exercise.program.seconds) + " each";
  const auto* result = context.results.get<ExerciseResult>(i);
  if (result == nullptr) return context.finish(std::move(made), false, {});
  made.how = how_tried(*result);
  context.finish(std::move(made), true,
                 {result->starter, text_of(*result), solution == nullptr ? "" : solution->code,
                  context.versions().compiler, context.versions().page,
                  context.programs_sources(result->starter)});
}

void claim(const Snippet& snippet, std::size_t i, ClaimContext& context) {
  const std::string title = "snippet: " + first_line(snippet.shown);
  const Span extent = context.fence(snippet.span);
  Claim made = context.begin(Kind::snippet, i, title, extent);
  made.how = how_run(snippet, context.versions());
  made.limits = limits_of_run(snippet.seconds);
  const auto* result = context.results.get<ExampleResult>(i);
  if (result != nullptr) made.seconds = made.run_seconds = result->run_seconds;
  context.finish(
      std::move(made), result != nullptr,
      {result == nullptr ? "" : result->output, context.versions().compiler,
       context.sources.model(snippet.model.text), context.programs_sources(snippet.code.text)});
  claim_in_page(title, i, result, extent, context);
}

void claim(const Commands& commands, std::size_t i, ClaimContext& context) {
  Claim made = context.begin(Kind::commands, i, "commands: " + first_line(commands.code.text),
                             context.fence(commands.span));
  made.how = how_run(commands);
  made.limits = limits_of_run(commands.seconds);
  const auto* result = context.results.get<ExampleResult>(i);
  if (result != nullptr) made.run_seconds = result->run_seconds;
  // What they print on their way may tell of times and places; what is stated of it is a claim of
  // its own.
  context.finish(std::move(made), result != nullptr,
                 {result == nullptr ? "" : context.sources.files(result->files)});
}

void claim(const Output& output, std::size_t i, ClaimContext& context) {
  const std::string by = printer(context.lesson.blocks[output.example]);
  Claim made = context.begin(Kind::output, i, "the output of " + by, context.fence(output.span));
  const auto* result = context.results.get<OutputResult>(i);
  const auto* printed = context.results.get<ExampleResult>(output.example);
  if (result != nullptr) made.how = how_compared(output, *result, by);
  if (output.text.text.find("[..]") != std::string::npos) {
    made.limits = "any text may stand for [..]";
  }
  context.finish(std::move(made), result != nullptr,
                 {printed == nullptr ? "" : printed->output, context.versions().compiler});
}

void claim(const Unchecked& unchecked, std::size_t i, ClaimContext& context) {
  Claim made =
      context.begin(Kind::code, i, unchecked.language + ": " + first_line(unchecked.code.text),
                    context.fence(unchecked.span));
  made.status = Status::unchecked;
  made.reason = unchecked.because;
  context.finish(std::move(made), true, {});
}

}  // namespace mjcourse
