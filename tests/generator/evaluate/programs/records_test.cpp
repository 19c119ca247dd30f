#include "evaluate/programs/records.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

// The faults of records, one a line.
std::string faults_of(const std::string& lines) {
  std::vector<RecordFault> faults;
  read_records(lines, faults);
  std::string text;
  for (const RecordFault& fault : faults) {
    text += "<" + fault.name + "> " + fault.message + " | " + fault.cure + "\n";
  }
  return text;
}

TEST(Records, AreReadByTheirKinds) {
  std::vector<RecordFault> faults;
  const Records records = read_records(
      "{\"result\": \"x\", \"value\": 0.10000000000000001}\n"
      "{\"result\": \"word\", \"value\": \"so\\u0022\"}\n"
      "{\"result\": \"v\", \"value\": [1, 2]}\n"
      "{\"table\": \"x\", \"value\": [[\"t\", [0, 1]], [\"e\", [2, 3]]]}\n"
      "{\"snapshot\": \"x\", \"value\": {\"time\": 1, \"qpos\": [2], \"act\": []}}\n",
      faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(records.results.at("x"), Reported(0.1));
  EXPECT_EQ(records.results.at("word"), Reported("so\""));
  EXPECT_EQ(records.results.at("v"), Reported(std::vector<double>{1, 2}));
  ASSERT_EQ(records.tables.at("x").size(), 2u);
  EXPECT_EQ(records.tables.at("x")[1].name, "e");
  EXPECT_EQ(records.tables.at("x")[1].values, (std::vector<double>{2, 3}));
  EXPECT_EQ(records.snapshots.at("x").at("time"), std::vector<double>{1});
  EXPECT_TRUE(records.snapshots.at("x").at("act").empty());
}

// The helper header tells of a check when it is made first, and when it first fails.
TEST(Records, HaveOfACheckTheOneThatFailed) {
  std::vector<RecordFault> faults;
  const auto check = [](const std::string& name, const std::string& holds) {
    return "{\"check\": \"" + name + "\", \"value\": {\"holds\": " + holds +
           R"(, "meaning": "m", "found": "f", "points": 2, "line": 7}})" + "\n";
  };
  const Records records =
      read_records(check("a", "true") + check("b", "true") + check("a", "false"), faults);
  EXPECT_TRUE(faults.empty());
  ASSERT_EQ(records.checks.size(), 2u);
  EXPECT_EQ(records.checks[0].what, "a");
  EXPECT_FALSE(records.checks[0].holds);
  EXPECT_EQ(records.checks[0].points, 2);
  EXPECT_EQ(records.checks[0].line, 7);
  EXPECT_TRUE(records.checks[1].holds);
  EXPECT_NE(faults_of(check("a", "1")), "") << "no truth value";
}

TEST(Records, KeepTheDigitsOfWholeNumbers) {
  std::vector<RecordFault> faults;
  const Records records = read_records(
      "{\"result\": \"a\", \"value\": 9007199254740991}\n"
      "{\"result\": \"b\", \"value\": 9007199254740993}\n"
      "{\"result\": \"c\", \"value\": -9007199254740993}\n"
      "{\"result\": \"d\", \"value\": 18446744073709551615}\n"
      "{\"result\": \"e\", \"value\": 18446744073709551616}\n",
      faults);
  EXPECT_TRUE(faults.empty());
  EXPECT_EQ(records.results.at("a"), Reported(9007199254740991.0));
  EXPECT_EQ(records.results.at("b"), Reported(std::uint64_t{9007199254740993}));
  EXPECT_EQ(records.results.at("c"), Reported(std::int64_t{-9007199254740993}));
  EXPECT_EQ(records.results.at("d"), Reported(std::uint64_t{18446744073709551615u}));
  EXPECT_EQ(records.results.at("e"), Reported(0x1p64));
}

TEST(Records, AreRefusedOneByOne) {
  const std::string cure = " | look for how it came about, and report what is sound\n";
  EXPECT_EQ(faults_of("{\"result\": \"x\", \"value\": null}\n"),
            "<x> the result \"x\" holds what is not a finite number" + cure);
  EXPECT_EQ(faults_of("{\"result\": \"x\", \"value\": [1, null]}\n"),
            "<x> the result \"x\" holds what is not a finite number" + cure);
  EXPECT_EQ(faults_of("{\"result\": \"x\", \"value\": 1}\n{\"result\": \"x\", \"value\": 1}\n"),
            "<x> the result \"x\" is reported twice | give each a name of its own\n");
  EXPECT_EQ(faults_of("{\"result\": \"a b\", \"value\": 1}\n"),
            "<a b> the result \"a b\" has a name that no lesson can write | use letters, digits "
            "and `_`, as `largest_error`\n");
  EXPECT_EQ(faults_of("{\"table\": \"x\", \"value\": []}\n"),
            "<x> the table \"x\" has no columns" + cure);
  EXPECT_EQ(faults_of("{\"table\": \"x\", \"value\": [[\"a\", [1]], [\"a\", [1]]]}\n"),
            "<x> the table \"x\" has two columns \"a\"" + cure);
  EXPECT_EQ(faults_of("{\"table\": \"x\", \"value\": [[\"a\", [1]], [\"b\", []]]}\n"),
            "<x> the table \"x\" has columns of different lengths: 1 in \"a\", 0 in \"b\"" + cure);
  EXPECT_EQ(faults_of("{\"snapshot\": \"x\", \"value\": {\"time\": null}}\n"),
            "<x> the snapshot \"x\" holds what is not a finite number" + cure);
  for (const std::string torn : {"{\"result\": \"x\", \"val", "[1]", "{\"value\": 1}"}) {
    EXPECT_EQ(faults_of(torn), "<> what the program reported cannot be read: `" + torn +
                                   "` | report UTF-8, and from one thread at a time\n");
  }
}

// What a program writes without the helper header.
TEST(Records, OfTheWrongKindAreRefused) {
  const std::string unreadable = "` | report UTF-8, and from one thread at a time\n";
  for (const std::string line :
       {R"({"result": 5, "value": 1})", R"({"table": [], "value": 1})", R"({"result": "x"})"}) {
    EXPECT_EQ(faults_of(line),
              "<> what the program reported cannot be read: `" + line + unreadable);
  }
  const std::string cure = " | look for how it came about, and report what is sound\n";
  EXPECT_EQ(faults_of(R"({"table": "t", "value": [1]})"),
            "<t> the table \"t\" has a column that is not a name with a list of numbers" + cure);
  EXPECT_EQ(faults_of(R"({"table": "t", "value": [["a", 1]]})"),
            "<t> the table \"t\" holds what is not a list of numbers" + cure);
  EXPECT_EQ(faults_of(R"({"snapshot": "s", "value": 1})"),
            "<s> the snapshot \"s\" is not an object of fields" + cure);
  EXPECT_EQ(faults_of(R"({"result": "r", "value": {"a": 1}})"),
            "<r> the result \"r\" holds what is not a finite number" + cure);
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_EQ(faults_of(R"({"result": "d", "value": )" + deep + "}"),
            "<d> the result \"d\" holds what is not a finite number" + cure);
}

TEST(Records, OfALongNameAreRefused) {
  const std::string name(100'000, 'a');
  EXPECT_EQ(faults_of("{\"result\": \"" + name + "-\", \"value\": 1}"),
            "<" + name + "-> the result \"" + name.substr(0, 60) +
                "…\" has a name that no lesson can write | use letters, digits and `_`, as "
                "`largest_error`\n");
}

TEST(Records, AreQuotedInWholeCharacters) {
  const std::string line = std::string(59, '-') + "€";
  EXPECT_EQ(faults_of(line), "<> what the program reported cannot be read: `" + line.substr(0, 59) +
                                 "…` | report UTF-8, and from one thread at a time\n");
}

// A program with the course's own helper header.
EvaluationOf program(const std::string& statements) {
  const std::string code =
      "#include <mjcourse/mjcourse.hpp>\nusing namespace mjcourse;\nint main() {\n" + statements +
      "}\n";
  return EvaluationOf(
      "```cpp file=examples/a.cpp\n" + code + "```\n",
      {{"examples/a.cpp", code},
       {"examples/include/mjcourse/mjcourse.hpp",
        DiskFiles(MJCOURSE_ROOT).read("examples/include/mjcourse/mjcourse.hpp").value()}});
}

TEST(Records, AreWrittenByTheHelperHeader) {
  const EvaluationOf found = program(R"(  const Model model = load_model("ball");
  const Data data = make_data(model);
  result("count", model->nq);
  result("key", 9007199254740993);
  result("hash", 0xFFFFFFFFFFFFFFFFull);
  result("deep", true);
  result("third", 1.0 / 3);
  result("word", "a \"b\"\n\\ é");
  result("pose", qpos(model, data).head<3>());
  result("none", Eigen::VectorXd());
  table("energy", {{"t", std::vector<double>{0, 1}}, {"e", Eigen::Vector2d(2, 3)}});
  snapshot("start", model, data);
)");
  EXPECT_EQ(found.mistakes(), "");
  const Records& records = found.result<ExampleResult>().records;
  EXPECT_EQ(records.results.at("count"), Reported(8.0));
  EXPECT_EQ(records.results.at("key"), Reported(std::uint64_t{9007199254740993}));
  EXPECT_EQ(records.results.at("hash"), Reported(~std::uint64_t{0}));
  EXPECT_EQ(records.results.at("deep"), Reported(1.0));
  EXPECT_EQ(records.results.at("third"), Reported(1.0 / 3));
  EXPECT_EQ(records.results.at("word"), Reported("a \"b\"\n\\ é"));
  EXPECT_EQ(records.results.at("pose"), Reported(std::vector<double>{0, 0, 1}));
  EXPECT_EQ(records.results.at("none"), Reported(std::vector<double>{}));
  EXPECT_EQ(records.tables.at("energy")[1].values, (std::vector<double>{2, 3}));
  const auto& state = records.snapshots.at("start");
  EXPECT_EQ(state.at("qpos"), (std::vector<double>{0, 0, 1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(state.at("qvel").size(), 7u);
  EXPECT_EQ(state.at("ctrl").size(), 1u);
}

TEST(Records, AreBlamedWhereTheProgramNamesThem) {
  EXPECT_EQ(
      program("  result(\"ratio\", NAN);\n").mistakes(),
      R"(content/1-a/1.1-x.md:8:10: error: the result "ratio" holds what is not a finite number [E-example-record]
  8 |   result("ratio", NAN);
    |          ^~~~~~~
  cure: look for how it came about, and report what is sound
)");
}

TEST(Records, AreTenThousandAndAHundredWrongOnes) {
  std::vector<RecordFault> faults;
  EXPECT_TRUE(read_records(std::string(1 << 24, '\n'), faults).results.empty());
  ASSERT_EQ(faults.size(), 101U);
  EXPECT_EQ(faults[100].message, "a hundred records are wrong; those after them were not read");
  EXPECT_EQ(faults[100].cure, "fix the first ones: others often follow from them");
  faults.clear();
  std::string lines;
  for (int i = 0; i < 10'002; ++i) {
    lines += R"({"result": "r)" + std::to_string(i) + R"(", "value": 1})" + "\n";
  }
  EXPECT_EQ(read_records(lines, faults).results.size(), 10'000U);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].message, "the program reported more than 10000 records");
  EXPECT_EQ(faults[0].cure, "report lists as one record: `table`, or a list as a `result`");
}

}  // namespace
}  // namespace mjcourse
