#include "report/sarif.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

using nlohmann::json;

// The one run of the log of `diagnostics`.
json run_of(const Diagnostics& diagnostics) {
  const json log = sarif_log(diagnostics, "docs", "0.1.0");
  EXPECT_EQ(log["version"], "2.1.0");
  EXPECT_EQ(log["runs"].size(), 1u);
  return log["runs"][0];
}

TEST(Sarif, NamesTheToolAndEachRuleOnce) {
  const Diagnostics two{error_at({"a.md", 1, 1, 1, ""}, "E-b", "x"),
                        error_at({"a.md", 2, 1, 1, ""}, "E-a", "y"),
                        error_at({"a.md", 3, 1, 1, ""}, "E-b", "z")};
  const json run = run_of(two);
  EXPECT_EQ(run["tool"]["driver"], json::parse(R"({"name": "mjcourse", "version": "0.1.0",
                            "rules": [{"id": "E-a"}, {"id": "E-b"}]})"));
  EXPECT_EQ(run["results"][0]["ruleIndex"], 1);
  EXPECT_EQ(run["results"][1]["ruleIndex"], 0);
}

TEST(Sarif, SaysWhatARuleMeans) {
  const json rule =
      run_of({error_at({"a.md", 1, 1, 1, ""}, "E-json-syntax", "x")})["tool"]["driver"]["rules"][0];
  EXPECT_EQ(
      rule["help"]["text"],
      "The body of a fence is not valid JSON. The caret shows where parsing stopped. The missing "
      "character is usually just before it: a comma, a quotation mark or a bracket. JSON has no "
      "comments, and no comma after the last entry.\n"
      "wrong: `{\"height\": 200,}`\n"
      "right: `{\"height\": 200}`\n");
}

TEST(Sarif, PlacesAResultAndItsNotes) {
  Diagnostic error = error_at({"models/ä b.xml", 5, 3, 4, "  <geo/>"}, "E-model-mjcf",
                              "unrecognized element", "write <geom/>");
  error.notes = {{"lesson 1.1 uses this model", {"content/1.1.md", 7, 1, 2, ""}}, {"so", {}}};
  EXPECT_EQ(run_of({error})["results"][0], json::parse(R"({
    "ruleId": "E-model-mjcf", "ruleIndex": 0, "level": "error",
    "message": {"text": "unrecognized element\ncure: write <geom/>"},
    "locations": [{"physicalLocation": {
      "artifactLocation": {"uri": "docs/models/%C3%A4%20b.xml", "uriBaseId": "%SRCROOT%"},
      "region": {"startLine": 5, "startColumn": 3, "endColumn": 7,
                 "snippet": {"text": "  <geo/>"}}}}],
    "relatedLocations": [
      {"message": {"text": "lesson 1.1 uses this model"},
       "physicalLocation": {
         "artifactLocation": {"uri": "docs/content/1.1.md", "uriBaseId": "%SRCROOT%"},
         "region": {"startLine": 7, "startColumn": 1, "endColumn": 3}}},
      {"message": {"text": "so"},
       "physicalLocation": {
         "artifactLocation": {"uri": "docs/models/%C3%A4%20b.xml", "uriBaseId": "%SRCROOT%"},
         "region": {"startLine": 5, "startColumn": 3, "endColumn": 7,
                    "snippet": {"text": "  <geo/>"}}}}]})"));
}

TEST(Sarif, HasNoRegionForAFileAsAWhole) {
  Diagnostic warning = error_at({"content/course.yaml", 0, 0, 1, ""}, "W-x", "x");
  warning.severity = Severity::warning;
  const json result = run_of({warning})["results"][0];
  EXPECT_EQ(result["level"], "warning");
  EXPECT_FALSE(result["locations"][0]["physicalLocation"].contains("region"));
}

}  // namespace
}  // namespace mjcourse
