#include "evaluate/scenes/pin.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"
#include "evaluate/scenes/lab_text.h"
#include "physics/picture.h"

namespace mjcourse {
namespace {

constexpr const char* kPath = "content/1-a/pictures/1.1-ball.png";

// A pinned figure of the ball, `run` before it is drawn, beside that reference.
EvaluationOf pinned(const std::string& run, const std::string& reference = "",
                    const std::string& size = "[200, 100]") {
  std::map<std::string, std::string> files;
  if (!reference.empty()) files[kPath] = reference;
  return EvaluationOf(R"(```figure
{"model": "ball", "alt": "A.", "pin": "ball", "camera": {"elevation": -10, "distance": 3},
 "run": ")" + run +
                          "\", \"size\": " + size + "}\n```\n",
                      files);
}

std::string reference() {
  return pinned("").diagnostics().at(0).edit.value().text;
}

PinComparison only_pin(const EvaluationOf& found) {
  const auto pins = pins_of(found.evaluation().lessons.at(0));
  EXPECT_EQ(pins.size(), 1U);
  return *pins.at(0);
}

TEST(Pin, IsMadeWhereItIsMissing) {
  const EvaluationOf found = pinned("");
  ASSERT_EQ(found.diagnostics().size(), 1U);
  const Diagnostic& diagnostic = found.diagnostics()[0];
  EXPECT_EQ(diagnostic.id, "E-picture-unpinned");
  EXPECT_EQ(diagnostic.edit.value().file, kPath);
  EXPECT_FALSE(diagnostic.edit->span);
  EXPECT_EQ(diagnostic.edit->what, "the reference picture \"ball\" of lesson 1.1");
  const Picture made = decode_png(diagnostic.edit->text).value();
  EXPECT_EQ(made.width, 160);
  EXPECT_EQ(made.height, 80);
  const PinComparison pin = only_pin(found);
  EXPECT_FALSE(pin.agrees);
  EXPECT_TRUE(pin.reference.empty());
  EXPECT_EQ(pin.actual.bytes(), diagnostic.edit->text);
}

TEST(Pin, HoldsAPictureToIt) {
  const EvaluationOf found = pinned("", reference());
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_TRUE(only_pin(found).agrees);
  EXPECT_EQ(only_pin(found).name, "ball");
}

TEST(Pin, KeepsAllThreePicturesOfADifference) {
  const std::string before = reference();
  const EvaluationOf found = pinned("data.qpos[2] = 1.02", before);
  ASSERT_EQ(found.diagnostics().size(), 1U);
  EXPECT_EQ(found.diagnostics()[0].id, "E-picture-differs");
  const PinComparison pin = only_pin(found);
  EXPECT_FALSE(pin.agrees);
  EXPECT_EQ(pin.reference.bytes(), before);
  EXPECT_NE(pin.actual.bytes(), before);
  EXPECT_EQ(found.diagnostics()[0].edit.value().text, pin.actual.bytes());
  EXPECT_EQ(decode_png(pin.difference.bytes()).value().width, 160);
  EXPECT_EQ(pinned("data.qpos[2] = 1.02", pin.actual.bytes()).mistakes(), "");
}

TEST(Pin, TellsAReferenceOfAnotherShape) {
  const EvaluationOf found = pinned("", reference(), "[200, 120]");
  ASSERT_EQ(found.diagnostics().size(), 1U);
  EXPECT_EQ(found.diagnostics()[0].message,
            "this picture does not have the shape of its reference " + std::string(kPath) +
                ": that is 160 × 80 pixels, and this would be 160 × 96");
}

TEST(Pin, MakesOneAnewThatCannotBeRead) {
  const EvaluationOf found = pinned("", reference().substr(0, 200));
  ASSERT_EQ(found.diagnostics().size(), 1U);
  EXPECT_EQ(found.diagnostics()[0].id, "E-picture-unreadable");
  EXPECT_EQ(found.diagnostics()[0].edit.value().text, reference());
}

TEST(Pin, IsKeptOfALabsPosterToo) {
  const EvaluationOf found(lab_text(R"("pin": "ball")"));
  ASSERT_EQ(found.diagnostics().size(), 1U);
  EXPECT_EQ(found.diagnostics()[0].id, "E-picture-unpinned");
  EXPECT_EQ(only_pin(found).actual.bytes(), found.diagnostics()[0].edit.value().text);
}

// A picture too small for it has a reference of its own size.
TEST(Pin, IsNoLargerThanThePicture) {
  const EvaluationOf found = pinned("", "", "[40, 20]");
  EXPECT_EQ(decode_png(found.diagnostics().at(0).edit.value().text).value().width, 80);
}

}  // namespace
}  // namespace mjcourse
