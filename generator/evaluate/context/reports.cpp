#include "evaluate/context/reports.h"

#include <type_traits>
#include <variant>

#include "base/nearest.h"

namespace mjcourse {
namespace {

template <typename T>
std::vector<std::string> names_of(const std::map<std::string, T>& things) {
  std::vector<std::string> names;
  for (const auto& [name, thing] : things) names.push_back(name);
  return names;
}

// What an example reports.
struct RecordKind {
  const char* missing;    // the diagnostic's id where there is none of a name
  std::string name;       // as messages call it, and the function of the helper header
  const char* arguments;  // what that function takes besides the name
};
const RecordKind kResult{"E-example-result", "result", "…"};
const RecordKind kSnapshot{"E-example-snapshot", "snapshot", "model, data"};
const RecordKind kTable{"E-example-table", "table", "…"};

// The record `name` of `example`; null (reported) where it has none of that name.
template <typename Value>
const Value* find_record(const std::map<std::string, Value>& records, const RecordKind& kind,
                         const LocatedText& example, const LocatedText& name,
                         const SourceText& lesson, Diagnostics& diagnostics) {
  if (const auto found = records.find(name.text); found != records.end()) return &found->second;
  const std::string call = kind.name + "(\"" + name.text + "\", " + kind.arguments + ")";
  diagnostics.push_back(error_at(
      place_of(lesson, name.span()), kind.missing,
      "the example `" + example.text + "` reports no " + kind.name + " `" + name.text + "`",
      records.empty() ? "report it there: `" + call + "`" : suggest(name.text, names_of(records))));
  return nullptr;
}

}  // namespace

std::optional<double> as_double(const Reported& reported) {
  return std::visit(
      []<typename Kind>(const Kind& known) -> std::optional<double> {
        if constexpr (std::is_arithmetic_v<Kind>) return static_cast<double>(known);
        return std::nullopt;
      },
      reported);
}

void Reports::add(const std::string& example, const ExampleResult* result) {
  const ExampleResult*& known = results_[example];
  if (known == nullptr) known = result;  // several lessons may show the same example
}

std::vector<std::string> Reports::examples() const {
  return names_of(results_);
}

std::map<std::string, std::optional<Records>> Reports::records() const {
  std::map<std::string, std::optional<Records>> told;
  for (const auto& [example, result] : results_) {
    told[example] = result == nullptr ? std::nullopt : std::optional(result->records);
  }
  return told;
}

const Records* Reports::records_of(const LocatedText& example, const SourceText& lesson,
                                   Diagnostics& diagnostics) const {
  const auto known = results_.find(example.text);
  if (known != results_.end()) {
    return known->second != nullptr ? &known->second->records : nullptr;
  }
  diagnostics.push_back(error_at(place_of(lesson, example.span()), "E-example-unknown",
                                 "no lesson has an example `" + example.text + "`",
                                 suggest(example.text, examples())));
  return nullptr;
}

const Reported* Reports::find(const LocatedText& example, const LocatedText& result,
                              const SourceText& lesson, Diagnostics& diagnostics) const {
  const Records* records = records_of(example, lesson, diagnostics);
  if (records == nullptr) return nullptr;
  return find_record(records->results, kResult, example, result, lesson, diagnostics);
}

const State* Reports::find_snapshot(const LocatedText& example, const LocatedText& snapshot,
                                    const SourceText& lesson, Diagnostics& diagnostics) const {
  const Records* records = records_of(example, lesson, diagnostics);
  if (records == nullptr) return nullptr;
  return find_record(records->snapshots, kSnapshot, example, snapshot, lesson, diagnostics);
}

const Table* Reports::find_table(const LocatedText& example, const LocatedText& table,
                                 const SourceText& lesson, Diagnostics& diagnostics) const {
  const Records* records = records_of(example, lesson, diagnostics);
  if (records == nullptr) return nullptr;
  return find_record(records->tables, kTable, example, table, lesson, diagnostics);
}

}  // namespace mjcourse
