#include "cli/document.h"

#include <algorithm>
#include <map>

#include "page/html/verification.h"
#include "report/github.h"
#include "report/junit.h"
#include "report/other_tools.h"
#include "report/sarif.h"
#include "report/terminal.h"

namespace mjcourse {
namespace {

// The course's folder as a caller outside of it sees it: relative to where they are.
std::string folder_of(const CheckOptions& options) {
  return options.course.lexically_relative(std::filesystem::current_path()).string();
}

// An error tells the story of a claim that failed.
TestCase case_of(const Claim& claim) {
  TestCase one{claim.what, claim.place.line, claim.seconds};
  const std::string why = claim.reason.empty() ? "" : ": " + claim.reason;
  if (claim.status == Claim::Status::asserted) one.skipped = "asserted" + why;
  if (claim.status == Claim::Status::unchecked) one.skipped = "not run" + why;
  return one;
}

TestCase case_of(const Diagnostic& error) {
  TestCase one{error.message, error.place.line};
  one.failure = format_for_terminal(error);
  one.id = error.id;
  return one;
}

// A suite for each lesson, and behind them one for each other file that has an error.
std::vector<TestSuite> suites_of(const Verified& verified, const std::string& folder) {
  std::vector<TestSuite> suites;
  std::map<std::string, std::size_t> by_file;
  const auto add = [&](const std::string& name, const std::string& file) {
    by_file[file] = suites.size();
    suites.push_back({name, course_path(folder, file), {}});
  };
  for (const Lesson* page :
       verified.course ? verified.course->pages() : std::vector<const Lesson*>()) {
    const std::string& title = page->front.title.text;
    const std::string number = page->number.empty() ? "" : page->number + " ";
    add(number + (title.empty() ? page->slug : title), page->source->path());
    for (const Claim& claim : verified.evaluation.results_of(*page).claims) {
      if (claim.status != Claim::Status::failed) suites.back().cases.push_back(case_of(claim));
    }
  }
  for (const Diagnostic& diagnostic : verified.evaluation.diagnostics) {
    if (diagnostic.severity != Severity::error) continue;
    const std::string& file = diagnostic.place.file;
    if (!by_file.contains(file)) add(file, file);
    suites[by_file[file]].cases.push_back(case_of(diagnostic));
  }
  return suites;
}

}  // namespace

std::string document_of(const Verified& verified, const CheckOptions& options) {
  const Evaluation& evaluation = verified.evaluation;
  const std::string folder = folder_of(options);
  switch (options.format) {
    case Format::text:
      return "";
    case Format::json:
      return json_file(full_verification(verified.course ? &*verified.course : nullptr, evaluation,
                                         verified.seconds));
    case Format::github:
      return github_annotations(evaluation.diagnostics, folder);
    case Format::sarif:
      return json_file(sarif_log(evaluation.diagnostics, folder, evaluation.versions.mjcourse));
    case Format::junit:
      return junit_xml(suites_of(verified, folder), verified.seconds);
  }
  return "";
}

}  // namespace mjcourse
