#include "evaluate/reports.h"

#include "base/nearest.h"

namespace mjcourse {

void Reports::add(const std::string& example, const ExampleResult* result) {
  const ExampleResult*& known = results_[example];
  if (known == nullptr) known = result;  // several lessons may show the same example
}

std::vector<std::string> Reports::examples() const {
  std::vector<std::string> names;
  for (const auto& [name, result] : results_) names.push_back(name);
  return names;
}

std::optional<Reported> Reports::find(const LocatedText& example, const LocatedText& result,
                                      const SourceText& lesson, Diagnostics& diagnostics) const {
  const auto known = results_.find(example.text);
  if (known == results_.end()) {
    diagnostics.push_back(error_at(place_of(lesson, example.span()), "E-example-unknown",
                                   "no lesson has an example `" + example.text + "`",
                                   suggest(example.text, examples())));
    return std::nullopt;
  }
  if (known->second == nullptr) return std::nullopt;
  const std::map<std::string, Reported>& results = known->second->records.results;
  if (const auto found = results.find(result.text); found != results.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [name, value] : results) names.push_back(name);
  diagnostics.push_back(
      error_at(place_of(lesson, result.span()), "E-example-result",
               "the example `" + example.text + "` reports no result `" + result.text + "`",
               names.empty() ? "report it there: `result(\"" + result.text + "\", …)`"
                             : suggest(result.text, names)));
  return std::nullopt;
}

}  // namespace mjcourse
