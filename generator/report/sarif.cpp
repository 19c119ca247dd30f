#include "report/sarif.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "base/percent_encoding.h"
#include "report/meaning.h"
#include "report/other_tools.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr const char* kSchema = "https://json.schemastore.org/sarif-2.1.0.json";

// A path as a relative reference (RFC 3986).
std::string uri_of(const std::string& path) {
  constexpr std::string_view marks = "/!$&'()*+,;=@";
  return percent_encoded(path,
                         [&](char c) { return is_unreserved(c) || marks.find(c) != marks.npos; });
}

class Sarif {
 public:
  Sarif(const std::string& folder, const Diagnostics& diagnostics) : folder_(folder) {
    for (const Diagnostic& diagnostic : diagnostics) rules_.push_back(diagnostic.id);
    std::sort(rules_.begin(), rules_.end());
    rules_.erase(std::unique(rules_.begin(), rules_.end()), rules_.end());
  }

  json rules() const {
    json all = json::array();
    for (const std::string& id : rules_) all.push_back(rule(id));
    return all;
  }

  json result(const Diagnostic& diagnostic) const {
    const auto rule = std::lower_bound(rules_.begin(), rules_.end(), diagnostic.id);
    json related = json::array();
    for (const Note& note : diagnostic.notes) {
      json one = location(note.place.file.empty() ? diagnostic.place : note.place);
      one["message"] = {{"text", note.message}};
      related.push_back(std::move(one));
    }
    json all{{"ruleId", diagnostic.id},
             {"ruleIndex", rule - rules_.begin()},
             {"level", diagnostic.severity == Severity::error ? "error" : "warning"},
             {"message", {{"text", message_with_cure(diagnostic)}}},
             {"locations", {location(diagnostic.place)}}};
    if (!related.empty()) all["relatedLocations"] = std::move(related);
    return all;
  }

 private:
  // §3.49: with what the diagnostic means, which viewers show beside a result.
  static json rule(const std::string& id) {
    json one{{"id", id}};
    if (const Meaning* meaning = meaning_of(id)) {
      one["help"] = {{"text", plain_text_of(*meaning)}};
    }
    return one;
  }

  // §3.29; the region's end is the column behind it (§3.30.8).
  json location(const Place& place) const {
    json physical{
        {"artifactLocation",
         {{"uri", uri_of(course_path(folder_, place.file))}, {"uriBaseId", "%SRCROOT%"}}}};
    if (place.line > 0) {
      json region{{"startLine", place.line}};
      if (place.column > 0) {
        region["startColumn"] = place.column;
        region["endColumn"] = place.column + place.width;
      }
      if (!place.excerpt.empty()) region["snippet"] = {{"text", place.excerpt}};
      physical["region"] = std::move(region);
    }
    return {{"physicalLocation", std::move(physical)}};
  }

  const std::string& folder_;
  std::vector<std::string> rules_;  // ids, in order
};

}  // namespace

json sarif_log(const Diagnostics& diagnostics, const std::string& folder,
               const std::string& version) {
  const Sarif sarif(folder, diagnostics);
  json results = json::array();
  for (const Diagnostic& diagnostic : diagnostics) results.push_back(sarif.result(diagnostic));
  const json driver{{"name", "mjcourse"}, {"version", version}, {"rules", sarif.rules()}};
  return {{"$schema", kSchema},
          {"version", "2.1.0"},
          {"runs",
           {{{"tool", {{"driver", driver}}},
             {"columnKind", "unicodeCodePoints"},
             {"results", std::move(results)}}}}};
}

}  // namespace mjcourse
