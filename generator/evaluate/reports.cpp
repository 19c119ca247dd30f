#include "evaluate/reports.h"

#include "base/nearest.h"

namespace mjcourse {
namespace {

template <typename T>
std::vector<std::string> names_of(const std::map<std::string, T>& things) {
  std::vector<std::string> names;
  for (const auto& [name, thing] : things) names.push_back(name);
  return names;
}

}  // namespace

void Reports::add(const std::string& example, const ExampleResult* result) {
  const ExampleResult*& known = results_[example];
  if (known == nullptr) known = result;  // several lessons may show the same example
}

std::vector<std::string> Reports::examples() const {
  return names_of(results_);
}

// Null when there is no such example (reported), or when it failed.
const Records* Reports::records_of(const LocatedText& example, const SourceText& lesson,
                                   Diagnostics& diagnostics) const {
  const auto known = results_.find(example.text);
  if (known == results_.end()) {
    diagnostics.push_back(error_at(place_of(lesson, example.span()), "E-example-unknown",
                                   "no lesson has an example `" + example.text + "`",
                                   suggest(example.text, examples())));
    return nullptr;
  }
  return known->second != nullptr ? &known->second->records : nullptr;
}

std::optional<Reported> Reports::find(const LocatedText& example, const LocatedText& result,
                                      const SourceText& lesson, Diagnostics& diagnostics) const {
  const Records* records = records_of(example, lesson, diagnostics);
  if (records == nullptr) return std::nullopt;
  const std::map<std::string, Reported>& results = records->results;
  if (const auto found = results.find(result.text); found != results.end()) return found->second;
  diagnostics.push_back(
      error_at(place_of(lesson, result.span()), "E-example-result",
               "the example `" + example.text + "` reports no result `" + result.text + "`",
               results.empty() ? "report it there: `result(\"" + result.text + "\", …)`"
                               : suggest(result.text, names_of(results))));
  return std::nullopt;
}

const std::vector<Records::Column>* Reports::find_table(const LocatedText& example,
                                                        const LocatedText& table,
                                                        const SourceText& lesson,
                                                        Diagnostics& diagnostics) const {
  const Records* records = records_of(example, lesson, diagnostics);
  if (records == nullptr) return nullptr;
  const auto found = records->tables.find(table.text);
  if (found != records->tables.end()) return &found->second;
  diagnostics.push_back(
      error_at(place_of(lesson, table.span()), "E-example-table",
               "the example `" + example.text + "` reports no table `" + table.text + "`",
               records->tables.empty() ? "report it there: `table(\"" + table.text + "\", …)`"
                                       : suggest(table.text, names_of(records->tables))));
  return nullptr;
}

}  // namespace mjcourse
