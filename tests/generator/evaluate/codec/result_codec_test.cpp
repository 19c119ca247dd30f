#include "evaluate/codec/result_codec.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "memory_store.h"

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
std::string formula(const json& markup, const json& work = 0.5) {
  return cbor({{"results", {{0, {0, {{"markup", markup}}}, 0.5}}},
               {"pages", json::array()},
               {"model", json::array()},
               {"work", work}});
}

TEST(ResultCodec, GivesNothingForWhatIsNoFinding) {
  EXPECT_TRUE(decodes(formula("<b>x</b>")));
  EXPECT_FALSE(decodes(formula(5)));
  EXPECT_FALSE(decodes(formula("\xff"))) << "no text";
  EXPECT_FALSE(decodes(formula("x", "long")));
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

}  // namespace
}  // namespace mjcourse
