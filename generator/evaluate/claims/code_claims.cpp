// The claims of programs, and of what a lesson shows of them.
// Tested by tests/generator/evaluate/claims/claims_test.cpp.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "evaluate/claims/claim_text.h"
#include "evaluate/claims/lesson_claims.h"

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

// The first line of `code` that says something.
std::string first_line(const std::string& code) {
  const std::size_t begin = std::min(code.find_first_not_of(" \t\n"), code.size());
  return as_title(code.substr(begin, code.find('\n', begin) - begin));
}

// Who printed an output.
std::string printer(const Block& block) {
  if (const auto* example = std::get_if<Example>(&block)) return example->name() + ".cpp";
  return std::holds_alternative<Commands>(block) ? "the commands above it" : "the snippet above it";
}

}  // namespace

void LessonClaims::add_program(std::size_t i, const Example& example, const ExampleResult* result,
                               Span extent) {
  Claim claim = begin(Kind::program, i, example.file.text, extent);
  claim.how = how_run(example, versions());
  if (example.compiles) claim.limits = limits_of_run(example.seconds);
  if (result == nullptr) return finish(std::move(claim), false, {example.code.text});
  claim.run_seconds = result->run_seconds;
  finish(std::move(claim), true,
         {result->code, result->output, text_of(result->records), versions().compiler,
          programs_sources(result->code)});
}

void LessonClaims::add(std::size_t i, const Example& example) {
  const Span extent = fence(example.span);
  const auto program = programs_.find(example.file.text);
  const ExampleResult* whole = program == programs_.end() ? nullptr : &program->second;
  if (!example.region) return add_program(i, example, whole, extent);
  // An error inside the fence is the region's own; of the program's there, none would be left.
  if (stands_.contains({index_, i})) add_program(i, example, whole, {extent.begin, extent.begin});
  Claim claim = begin(Kind::region, i, example.file.text + "#" + example.region->text, extent);
  claim.how = "compared with these lines of " + example.file.text + ", which was compiled and run";
  claim.limits = "indentation does not count";
  claim.seconds = 0;
  const auto* result = results_.get<ExampleResult>(i);
  finish(std::move(claim), result != nullptr,
         {result == nullptr ? "" : result->code, whole == nullptr ? "" : whole->code});
}

void LessonClaims::add(std::size_t i, const Snippet& snippet) {
  Claim claim =
      begin(Kind::snippet, i, "snippet: " + first_line(snippet.shown), fence(snippet.span));
  claim.how = how_run(snippet, versions());
  claim.limits = limits_of_run(snippet.seconds);
  const auto* result = results_.get<ExampleResult>(i);
  if (result != nullptr) claim.seconds = claim.run_seconds = result->run_seconds;
  finish(std::move(claim), result != nullptr,
         {result == nullptr ? "" : result->output, versions().compiler,
          sources_.model(snippet.model.text), programs_sources(snippet.code.text)});
}

void LessonClaims::add(std::size_t i, const Commands& commands) {
  Claim claim =
      begin(Kind::commands, i, "commands: " + first_line(commands.code.text), fence(commands.span));
  claim.how = how_run(commands);
  claim.limits = limits_of_run(commands.seconds);
  const auto* result = results_.get<ExampleResult>(i);
  if (result != nullptr) claim.run_seconds = result->run_seconds;
  // What they print on their way may tell of times and places; what is stated of it is a claim of
  // its own.
  finish(std::move(claim), result != nullptr,
         {result == nullptr ? "" : sources_.files(result->files)});
}

void LessonClaims::add(std::size_t i, const Output& output) {
  const std::string by = printer(lesson_.blocks[output.example]);
  Claim claim = begin(Kind::output, i, "the output of " + by, fence(output.span));
  const auto* result = results_.get<OutputResult>(i);
  const auto* printed = results_.get<ExampleResult>(output.example);
  if (result != nullptr) claim.how = how_compared(output, *result, by);
  if (output.text.text.find("[..]") != std::string::npos) {
    claim.limits = "any text may stand for [..]";
  }
  finish(std::move(claim), result != nullptr,
         {printed == nullptr ? "" : printed->output, versions().compiler});
}

void LessonClaims::add(std::size_t i, const Unchecked& unchecked) {
  Claim claim = begin(Kind::code, i, unchecked.language + ": " + first_line(unchecked.code.text),
                      fence(unchecked.span));
  claim.status = Status::unchecked;
  claim.reason = unchecked.because;
  finish(std::move(claim), true, {});
}

}  // namespace mjcourse
