#include "lesson/blocks/read_proof.h"

#include <gtest/gtest.h>

#include "lesson/quiz_of.h"

namespace mjcourse {
namespace {

// The mistakes of a question of each kind with the proof `proof`.
std::string numeric(const std::string& proof) {
  return quiz_mistakes(R"({"kind": "numeric", "q": "?", "answer": 5, "verify": [)" + proof + "]}");
}
std::string mcq(const std::string& proof) {
  return quiz_mistakes(
      R"({"kind": "mcq", "q": "?", "options": ["a", "b"], "answer": 0, "verify": [)" + proof +
      "]}");
}
std::string order(const std::string& proof) {
  return quiz_mistakes(R"({"kind": "order", "q": "?", "items": ["a", "b"], "verify": [)" + proof +
                       "]}");
}

TEST(Proof, IsReadInEveryForm) {
  const ReadingOf reading = quiz_of(R"(
  {"kind": "numeric", "q": "?", "answer": 3, "verify": [
    {"joints": {"hinge": 2, "free": 1}, "value": "model.nv"},
    {"model": "zoo", "run": ["a;", "b;"], "seconds": 0.5, "value": "data.time", "equals": 4},
    {"mjcf": ["<mujoco>", "</mujoco>"], "value": "1"}, {"because": "it is a convention"}]},
  {"kind": "mcq", "q": "?", "options": ["a", "b"], "answer": 0, "verify": [
    {"model": "zoo", "options": ["true", "false"]},
    {"model": "zoo", "value": "1", "equals": 1}]},
  {"kind": "multi", "q": "?", "options": ["a", "b"], "answer": [0], "verify": [
    {"model": "zoo", "options": ["true", "false"]}]},
  {"kind": "order", "q": "?", "items": ["a", "b"], "verify": [
    {"model": "zoo", "values": ["1", "2"]}, {"model": "zoo", "value": "1", "equals": 1}]})");
  EXPECT_EQ(reading.mistakes(), "");
  const auto& questions = reading.only<Quiz>().questions;
  const auto& proofs = questions[0].proofs;
  ASSERT_EQ(proofs.size(), 4u);
  EXPECT_EQ(proofs[0].joints, (std::map<std::string, int>{{"free", 1}, {"hinge", 2}}));
  EXPECT_EQ(proofs[1].run.text, "a;\nb;");
  EXPECT_EQ(proofs[1].equals, 4);
  EXPECT_EQ(proofs[2].mjcf.text, "<mujoco>\n</mujoco>");
  EXPECT_EQ(proofs[3].because.text, "it is a convention");
  EXPECT_EQ(questions[1].proofs[0].options[1].text, "false");
  EXPECT_EQ(questions[2].proofs[0].options[0].text, "true");
  EXPECT_EQ(questions[3].proofs[0].values[1].text, "2");
}

TEST(Proof, BuildsOneThing) {
  const std::string form =
      "E-proof-form <{> a proof needs exactly one of \"joints\", \"model\", \"mjcf\", "
      "\"example\" and \"because\"\n";
  EXPECT_EQ(numeric(R"({"value": "1"})"), form);
  EXPECT_EQ(numeric(R"({"model": "a", "joints": {}, "value": "1"})"), form);
  EXPECT_EQ(numeric(R"({"model": "a", "mjcf": "<mujoco/>", "value": "1"})"), form);
  EXPECT_EQ(numeric(R"({"because": ""})"), form);
  EXPECT_EQ(numeric("3"), "E-json-kind <3> \"proof\" is a number; expected an object\n");
}

TEST(Proof, CountsJoints) {
  EXPECT_EQ(numeric(R"({"joints": {"hinge": -1}, "value": "1"})"),
            "E-json-range <-1> \"hinge\" counts joints: a whole number from 0 to 1000\n");
  EXPECT_EQ(numeric(R"({"joints": {"slide": 1.5, "hing": 3}, "value": "1"})"),
            "E-json-range <1.5> \"slide\" counts joints: a whole number from 0 to 1000\n"
            "E-json-key <hing> a set of joints has no key \"hing\" | did you mean `hinge`?\n");
}

TEST(Proof, OfANumberFindsAValue) {
  EXPECT_EQ(numeric(R"({"model": "a"})"), "E-proof-form <{> a proof needs a \"value\"\n");
  for (const std::string list : {"options", "values"}) {
    EXPECT_EQ(numeric(R"({"model": "a", "value": "1", ")" + list + R"(": ["1"]})"),
              "E-proof-form <{> a number is proved by a \"value\"\n");
  }
  EXPECT_EQ(numeric(R"({"model": "a", "value": "1", "equls": 3})"),
            "E-json-key <equls> a proof has no key \"equls\" | did you mean `equals`?\n");
}

TEST(Proof, OfAChoiceHasAnExpressionForEachOption) {
  const std::string either =
      "E-proof-form <{> a proof needs a \"value\", or \"options\" with one expression for each "
      "option\n";
  EXPECT_EQ(mcq(R"({"model": "a"})"), either);
  EXPECT_EQ(mcq(R"({"model": "a", "value": "1", "options": ["1", "2"]})"), either);
  EXPECT_EQ(mcq(R"({"model": "a", "options": ["1"]})"),
            "E-proof-form <{> the proof has 1 expression for 2 options | write one expression for "
            "each option, in their order\n");
  EXPECT_EQ(mcq(R"({"model": "a", "value": "1"})"),
            "E-proof-form <{> a choice is proved by \"options\", one expression each; a \"value\" "
            "needs \"equals\"\n");
  EXPECT_EQ(mcq(R"({"model": "a", "values": ["1", "2"]})"),
            "E-proof-form <{> a choice is proved by \"options\", one expression each\n");
  EXPECT_EQ(mcq(R"({"model": "a", "options": ["1", 2]})"),
            "E-json-kind <2> \"options\" is a number; expected a string\n");
}

TEST(Proof, OfAnOrderHasAnExpressionForEachItem) {
  const std::string either =
      "E-proof-form <{> a proof needs a \"value\", or \"values\" with one expression for each "
      "item\n";
  EXPECT_EQ(order(R"({"model": "a"})"), either);
  EXPECT_EQ(order(R"({"model": "a", "value": "1", "values": ["1", "2"]})"), either);
  EXPECT_EQ(order(R"({"model": "a", "values": ["1", "2", "3"]})"),
            "E-proof-form <{> the proof has 3 expressions for 2 items | write one expression for "
            "each item, in their order\n");
  EXPECT_EQ(order(R"({"model": "a", "value": "1"})"),
            "E-proof-form <{> an order is proved by \"values\", one expression each; a \"value\" "
            "needs \"equals\"\n");
  EXPECT_EQ(order(R"({"model": "a", "options": ["1", "2"]})"),
            "E-proof-form <{> an order is proved by \"values\", one expression each\n");
}

TEST(Proof, IsLeftOutWhenItDoesNotSayWhatToDo) {
  const ReadingOf reading = quiz_of(R"({"kind": "numeric", "q": "?", "answer": 5, "verify": [{},
      {"because": "so"}]})");
  EXPECT_EQ(reading.only<Quiz>().questions[0].proofs.size(), 1u);
}

TEST(Proof, OfAnExampleNamesAResult) {
  EXPECT_EQ(numeric(R"({"example": "x", "value": "y"})"), "");
  EXPECT_EQ(numeric(R"({"example": "x"})"), "E-proof-form <{> a proof needs a \"value\"\n");
  EXPECT_EQ(mcq(R"({"example": "x", "value": "y", "equals": 1})"), "");
  const std::string form =
      "E-proof-form <{> an \"example\" has run already: it takes the name of a result as "
      "\"value\", and no script\n";
  EXPECT_EQ(numeric(R"({"example": "x", "value": "y", "run": "z"})"), form);
  EXPECT_EQ(numeric(R"({"example": "x", "value": "y", "seconds": 1})"), form);
  EXPECT_EQ(mcq(R"({"example": "x", "options": ["y", "z"]})"), form);
}

}  // namespace
}  // namespace mjcourse
