#include "evaluate/result_codec.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "evaluate/result_fits.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

using nlohmann::json;

std::string cbor(const json& value) {
  const std::vector<std::uint8_t> bytes = json::to_cbor(value);
  return {bytes.begin(), bytes.end()};
}

bool decodes(const std::string& bytes) {
  MemoryStore store;
  return ResultCodec(store, "/course").decode(bytes, 0).has_value();
}

// A finding of one formula's markup.
std::string formula(const json& markup) {
  return cbor({{"results", {{0, {0, {{"markup", markup}}}, 0.5}}}, {"model", json::array()}});
}

TEST(ResultCodec, GivesNothingForWhatIsNoFinding) {
  EXPECT_TRUE(decodes(formula("<b>x</b>")));
  EXPECT_FALSE(decodes(formula(5)));
  EXPECT_FALSE(decodes(formula("\xff"))) << "no text";
  EXPECT_FALSE(decodes(formula("x") + "x"));
  EXPECT_FALSE(decodes(""));
  EXPECT_FALSE(decodes("\xa1\x61\xff\xf6")) << "a key that is no text";
}

TEST(ResultCodec, GoesDownIntoNothingThatIsTooDeep) {
  // As much as 99 lists in a list, and as a million.
  for (const std::size_t depth : {std::size_t{100}, std::size_t{1'000'000}}) {
    EXPECT_FALSE(decodes(std::string(depth, '\x81') + "\xf6"));
  }
}

// A lab of one readout, with one button.
const ReadingOf& lab() {
  static const ReadingOf reading = reading_of(
      "```lab simlab\n{\"title\": \"T\", \"model\": \"m\", \"alt\": \"A.\", \"controls\": "
      "[{\"type\": "
      "\"button\", \"label\": \"B\", \"run\": \"step(1)\"}], \"readouts\": [{\"label\": \"r\", "
      "\"expr\": \"1\"}]}\n```\n");
  return reading;
}

// Whether a result with one run, on which `control` acted and which read `values`, is that lab's.
bool fits_the_lab(std::optional<std::size_t> control, const std::vector<double>& values) {
  LabResult result;
  result.readouts = {1};
  result.keyframes = {0};
  result.runs = {{control, ControlValue(), {{0, values}}}};
  return fits(lab().lesson->blocks.at(0), Result(result)) &&
         fits(lab().lesson->blocks.at(0), result);
}

TEST(ResultFits, WhereEachRunHasThePartsOfItsLab) {
  EXPECT_TRUE(fits_the_lab(std::nullopt, {1}));
  EXPECT_TRUE(fits_the_lab(0, {1}));
  EXPECT_FALSE(fits_the_lab(1, {1}));
  EXPECT_FALSE(fits_the_lab(0, {}));
}

TEST(ResultFits, WhereColumnsAreEquallyLong) {
  const ReadingOf program = reading_of("```cpp file=examples/a.cpp\n```\n");
  ExampleResult result;
  result.records.tables["t"] = {{"a", {1}}, {"b", {2}}};
  EXPECT_TRUE(fits(program.lesson->blocks.at(0), Result(result)));
  result.records.tables["t"][1].values.clear();
  EXPECT_FALSE(fits(program.lesson->blocks.at(0), Result(result)));
}

}  // namespace
}  // namespace mjcourse
