#include "evaluate/programs/judge.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace mjcourse {
namespace {

const SipKey kKey{7, 8};

// Reports as a program with that key makes them.
class Reports7 {
 public:
  std::string of(const std::string& json) {
    const std::string numbered = std::to_string(number_++) + json + "\n";
    char digits[17];
    std::snprintf(
        digits, sizeof digits, "%016llx",
        static_cast<unsigned long long>(sip_hash(kKey, numbered.data(), numbered.size())));
    return digits + json;
  }
  std::string check(const std::string& what, const std::string& found) {
    return of(R"({"what": ")" + what + R"(", "meaning": "", "points": 1, "line": 3, )" + found +
              "}");
  }

 private:
  int number_ = 0;
};

// Twice `near`, once `plain`, in the solution's run.
Answers answers() {
  Reports7 reports;
  Judge author(kKey);
  const std::string expected = R"(, "expected": "2", "tolerance": "0.1")";
  EXPECT_EQ(author.hear(reports.check("near", R"("value": "2.05")" + expected)), "1");
  EXPECT_EQ(author.hear(reports.check("near", R"("value": "1.95")" + expected)), "1");
  EXPECT_EQ(author.hear(reports.check("plain", R"("holds": true)")), "");
  author.hear(reports.of(R"({"ended": true})"));
  EXPECT_TRUE(author.answers().hold());
  return author.answers();
}

// What the checks come to of a program that reports these.
std::vector<JudgedCheck> verdict(const std::vector<std::pair<std::string, std::string>>& made,
                                 bool is_ended = true) {
  const Answers known = answers();
  Reports7 reports;
  Judge judge(known, kKey);
  for (const auto& [what, found] : made) judge.hear(reports.check(what, found));
  if (is_ended) judge.hear(reports.of(R"({"ended": true})"));
  EXPECT_FALSE(judge.is_forged());
  return judge.verdict();
}

TEST(Judge, HoldsNumbersAgainstThoseOfTheSolution) {
  const auto all = verdict({{"near", R"("value": "2.09")"},
                            {"near", R"("value": "1.91")"},
                            {"plain", R"("holds": true)"}});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_TRUE(all[0].holds);
  EXPECT_FALSE(all[0].is_its_word);
  EXPECT_TRUE(all[1].holds);
  EXPECT_TRUE(all[1].is_its_word);
}

TEST(Judge, SaysHowFarOffTheFirstOneIs) {
  const auto all = verdict({{"near", R"("value": "2.5")"}, {"near", R"("value": "9")"}});
  EXPECT_FALSE(all[0].holds);
  EXPECT_EQ(all[0].found, "it is 2.5, and should be 2 ± 0.1: off by 0.5");
  EXPECT_FALSE(all[1].holds);
  EXPECT_EQ(all[1].meaning, "it was not reached");
}

TEST(Judge, BelievesNoProgramWhatTheSolutionMeasures) {
  const auto said = verdict({{"near", R"("holds": true)"}, {"near", R"("holds": true)"}});
  EXPECT_FALSE(said[0].holds);
  const std::string own = R"("value": "5", "expected": "5", "tolerance": "9")";
  EXPECT_FALSE(verdict({{"near", own}, {"near", own}})[0].holds);
  const std::string other = R"("value": "5", "other": "5", "tolerance": "9")";
  EXPECT_FALSE(verdict({{"near", other}, {"near", other}})[0].holds);
}

TEST(Judge, TakesNoVectorForANumberAndNoneThatIsNot) {
  for (const char* value : {"[ 2", "nan", "inf", "[", "[ 2 2"}) {
    const std::string found = R"("value": ")" + std::string(value) + "\"";
    EXPECT_FALSE(verdict({{"near", found}, {"near", found}})[0].holds) << value;
  }
}

TEST(Judge, CountsCalls) {
  const std::string right = R"("value": "2")";
  const auto one = verdict({{"near", right}, {"plain", R"("holds": true)"}});
  EXPECT_FALSE(one[0].holds) << "a program that ends early";
  EXPECT_EQ(one[0].found, "it was made 1 time, and 2 times with the solution");
  const auto failing = verdict({{"near", right}, {"plain", R"("holds": false)"}});
  EXPECT_TRUE(failing[0].holds) << "the rest may depend on what fails";
  EXPECT_TRUE(failing[0].is_its_word) << "as the program says itself";
  const auto cut = verdict({{"near", right}, {"plain", R"("holds": false)"}}, false);
  EXPECT_FALSE(cut[0].holds) << "or the program has been ended in between";
  EXPECT_FALSE(verdict({{"near", right}, {"near", right}, {"near", right}})[0].holds);
}

// In three rounds, the solution's run makes `a` and then `b`, which `a` guards.
TEST(Judge, LeavesOutCallsBehindOneThatFails) {
  Reports7 author_reports, reports;
  Judge author(kKey);
  for (const int round : {1, 2, 3}) {
    const std::string number = std::to_string(round);
    for (const char* what : {"a", "b"}) {
      author.hear(author_reports.check(what, "\"value\": \"" + number + "\", \"expected\": \"" +
                                                 number + "\", \"tolerance\": \"0\""));
    }
  }
  const Answers known = author.answers();
  Judge judge(known, kKey);
  const auto hear = [&](const char* what, const char* number) {
    return judge.hear(reports.check(what, "\"value\": \"" + std::string(number) + "\""));
  };
  EXPECT_EQ(hear("a", "1"), "1");
  EXPECT_EQ(hear("b", "1"), "1");
  EXPECT_EQ(hear("a", "7"), "0");
  EXPECT_EQ(hear("a", "3"), "1");
  EXPECT_EQ(hear("b", "3"), "1") << "of the third round, though it is the second call";
  EXPECT_EQ(hear("b", "3"), "0") << "there is none behind it";
  EXPECT_FALSE(judge.verdict()[0].holds);
  EXPECT_EQ(judge.verdict()[1].found, "it is 3, and the solution's run makes this check no more");
}

TEST(Judge, GivesNoPointsForChecksThatTheSolutionDoesNotMake) {
  const auto all = verdict({{"own", R"("holds": true)"}});
  ASSERT_EQ(all.size(), 3u);
  EXPECT_TRUE(all[2].holds);
  EXPECT_EQ(all[2].points, 0);
}

TEST(Judge, KnowsReportsOfSomebodyElse) {
  const Answers known = answers();
  const std::string report =
      R"({"what": "plain", "meaning": "", "points": 1, "line": 3, "holds": true})";
  for (const std::string& line : std::vector<std::string>{
           "", "x", report, "0000000000000007" + report, Reports7().of("{}"), Reports7().of("[]"),
           Reports7().check("plain", R"("holds": "true")"), "63cbe1e459320dd7"}) {
    Judge judge(known, kKey);
    EXPECT_EQ(judge.hear(line), "0") << line;
    EXPECT_TRUE(judge.is_forged()) << line;
  }
  Judge judge(known, kKey);
  const std::string line = Reports7().of(report);
  judge.hear(line);
  EXPECT_FALSE(judge.is_forged());
  judge.hear(line);
  EXPECT_TRUE(judge.is_forged()) << "a report that is made twice";
}

TEST(Judge, TellsOfAVectorWhichNumberIsOff) {
  Reports7 author_reports, reports;
  Judge author(kKey);
  author.hear(author_reports.check(
      "v", R"("value": "[ 1 2 3", "expected": "[ 1 2 3", "tolerance": "1e-9")"));
  const Answers known = author.answers();
  Judge judge(known, kKey);
  EXPECT_EQ(judge.hear(reports.check("v", R"("value": "[ 1 2.5 3")")), "0");
  EXPECT_EQ(judge.verdict()[0].found,
            "it is [1, 2.5, 3], and should be [1, 2, 3] ± 1e-09: off by 0.5");
  Judge shorter(known, kKey);
  shorter.hear(Reports7().check("v", R"("value": "[ 1 2")"));
  EXPECT_EQ(shorter.verdict()[0].found, "it has 2 numbers, and should have 3");
}

}  // namespace
}  // namespace mjcourse
