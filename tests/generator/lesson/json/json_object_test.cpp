#include "lesson/json/json_object.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <stdexcept>

namespace mjcourse {
namespace {

constexpr std::array kEngineKeys{
    Key{"name", KeyKind::text, "Its name.", Need::filled},
    Key{"power", KeyKind::number, "Its power.", Need::there, {0, 9, "is in kW: from 0 to 9"}},
    Key{"gears", KeyKind::whole, "Its gears.", Need::none, {1, 9, "counts gears"}},
    Key{"start", KeyKind::script, "How it starts."}};
constexpr Vocabulary kEngine{"engine", kEngineKeys};

// What is said of `json`, which `read` reads as an engine: id, message, cure.
std::string mistakes(const std::string& json, const std::function<void(JsonObject&)>& read) {
  const SourceText source("a.md", json);
  Diagnostics diagnostics;
  Reading reading(source, diagnostics);
  const std::optional<JsonValue> value = parse_json(located(source, {0, json.size()}), reading);
  JsonObject object(value.value(), kEngine, reading);
  read(object);
  std::string text;
  for (const Diagnostic& d : diagnostics) {
    text += d.id + " " + d.message + (d.cure.empty() ? "" : " | " + d.cure) + "\n";
  }
  return text;
}

void read_all(JsonObject& object) {
  object.string("name");
  object.number("power", 1);
  object.whole("gears", 5);
  object.script("start");
  object.finish();
}

TEST(JsonObject, MindsWhatItsVocabularyDoesNotAllow) {
  EXPECT_EQ(mistakes(R"({"name": "E", "power": 3, "gears": 6, "start": ["a", "b"]})", read_all),
            "");
  EXPECT_EQ(mistakes("{}", read_all),
            "E-json-missing this engine has no \"name\" | add \"name\": …\n"
            "E-json-missing this engine has no \"power\" | add \"power\": …\n");
  EXPECT_EQ(mistakes(R"({"name": "", "power": 10, "gears": 1.5, "starts": "a"})", read_all),
            "E-json-missing \"name\" is empty\n"
            "E-json-range \"power\" is in kW: from 0 to 9\n"
            "E-json-range \"gears\" counts gears\n"
            "E-json-key an engine has no key \"starts\" | did you mean `start`?\n");
  EXPECT_EQ(mistakes("[]", read_all), "E-json-kind \"engine\" is a list; expected an object\n");
}

TEST(JsonObject, SaysWhatAReaderKnowsBetter) {
  EXPECT_EQ(mistakes(R"({"petrol": 1, "oil": 2})",
                     [](JsonObject& object) {
                       EXPECT_EQ(object.misplaced("petrol")->number, 1);
                       EXPECT_EQ(object.misplaced("diesel"), nullptr);
                       object.require("name", "an engine without a name", "name it");
                       object.find("power");
                       object.find("gears");
                       object.find("start");
                       object.finish();
                     }),
            "E-json-missing an engine without a name | name it\n"
            "E-json-key an engine has no key \"oil\" | known: name, power, gears, start\n");
}

// What the author cannot cause is a fault of the reader's.
TEST(JsonObject, HoldsItsReaderToTheVocabulary) {
  const auto fault = [](const auto& read) {
    try {
      mistakes("{}", read);
    } catch (const std::logic_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(fault([](JsonObject& object) { object.string("colour"); }),
            "engine: its words lack colour");
  EXPECT_EQ(fault([](JsonObject& object) { object.string("power"); }),
            "engine: power is of another kind than its reader takes");
  EXPECT_EQ(fault([](JsonObject& object) { object.misplaced("power"); }),
            "engine: power is one of its words, and not misplaced");
  EXPECT_EQ(fault([](JsonObject& object) {
              object.string("name");
              object.finish();
            }),
            "engine: nobody reads power");
}

}  // namespace
}  // namespace mjcourse
