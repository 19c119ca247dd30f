// Reports: what the examples of the whole course told, for the lessons that quote it by the
// example's name.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "findings/result.h"
#include "lesson/syntax/located_text.h"
#include "report/diagnostic.h"

namespace mjcourse {

// A number as an answer is held against it; nothing for what is none.
std::optional<double> as_double(const Reported& reported);

class Reports {
 public:
  // `result` is null for an example that failed. It must outlive this.
  void add(const std::string& example, const ExampleResult* result);

  std::vector<std::string> examples() const;

  // What each of them told; nothing for one that failed.
  std::map<std::string, std::optional<Records>> records() const;

  // What `example` reported as `result`, recorded as `snapshot`, or as `table`. Null when there is
  // no such example or record (reported), or when the example failed, which was reported where it
  // stands.
  const Reported* find(const LocatedText& example, const LocatedText& result,
                       const SourceText& lesson, Diagnostics& diagnostics) const;
  const State* find_snapshot(const LocatedText& example, const LocatedText& snapshot,
                             const SourceText& lesson, Diagnostics& diagnostics) const;
  const Table* find_table(const LocatedText& example, const LocatedText& table,
                          const SourceText& lesson, Diagnostics& diagnostics) const;

 private:
  const Records* records_of(const LocatedText& example, const SourceText& lesson,
                            Diagnostics& diagnostics) const;

  std::map<std::string, const ExampleResult*> results_;
};

}  // namespace mjcourse
