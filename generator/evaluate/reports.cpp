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

const ExampleResult* Reports::find_example(const LocatedText& example, const SourceText& lesson,
                                           Diagnostics& diagnostics) const {
  const auto known = results_.find(example.text);
  if (known != results_.end()) return known->second;
  diagnostics.push_back(error_at(place_of(lesson, example.span()), "E-example-unknown",
                                 "no lesson has an example `" + example.text + "`",
                                 suggest(example.text, examples())));
  return nullptr;
}

namespace {

// The record `name` of `example`; nothing (reported) where it has none of that name. `kind` is what
// a message calls it, and `call` the function of the helper header that would make it.
template <typename Value>
std::optional<Value> find_record(const std::map<std::string, Value>& records,
                                 const LocatedText& example, const LocatedText& name,
                                 const std::string& kind, const std::string& call,
                                 const SourceText& lesson, Diagnostics& diagnostics) {
  if (const auto found = records.find(name.text); found != records.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [known, value] : records) names.push_back(known);
  diagnostics.push_back(
      error_at(place_of(lesson, name.span()), "E-example-" + kind,
               "the example `" + example.text + "` reports no " + kind + " `" + name.text + "`",
               names.empty() ? "report it there: `" + call + "`" : suggest(name.text, names)));
  return std::nullopt;
}

}  // namespace

std::optional<Reported> Reports::find(const LocatedText& example, const LocatedText& result,
                                      const SourceText& lesson, Diagnostics& diagnostics) const {
  const ExampleResult* found = find_example(example, lesson, diagnostics);
  if (found == nullptr) return std::nullopt;
  return find_record(found->records.results, example, result, "result",
                     "result(\"" + result.text + "\", …)", lesson, diagnostics);
}

std::optional<State> Reports::find_snapshot(const LocatedText& example, const LocatedText& snapshot,
                                            const SourceText& lesson,
                                            Diagnostics& diagnostics) const {
  const ExampleResult* found = find_example(example, lesson, diagnostics);
  if (found == nullptr) return std::nullopt;
  return find_record(found->records.snapshots, example, snapshot, "snapshot",
                     "snapshot(\"" + snapshot.text + "\", model, data)", lesson, diagnostics);
}

}  // namespace mjcourse
