#include "cli/kept_verdicts.h"

#include <gtest/gtest.h>

#include <string>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

Grade grade() {
  GradedCheck falls;
  falls.what = "it falls";
  falls.points = 2;
  return {"fall", "A fall", "1.1", true, {falls}};
}

class KeptVerdictsTest : public testing::Test {
 protected:
  KeptVerdicts kept() const { return {folder_.path() / "results", folder_.path() / "course"}; }
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((folder_.path() / "results" / name).parent_path());
    write_file(folder_.path() / "results" / name, bytes);
  }

  const TemporaryFolder folder_;
};

TEST_F(KeptVerdictsTest, AreFoundAgainByTheirKey) {
  Grade holds = grade();
  holds.checks[0].holds = true;
  kept().keep("a1", holds);
  ASSERT_TRUE(kept().find("a1", grade()));
  EXPECT_TRUE(kept().find("a1", grade())->checks[0].holds);
  EXPECT_FALSE(kept().find("a2", grade()));
}

TEST_F(KeptVerdictsTest, AreNoneOfWhatOthersMayHaveBroughtAbout) {
  Grade slow = grade();
  const auto fault = [](const std::string& id, const std::string& message) {
    return nlohmann::json::array({{{"id", id}, {"message", message}, {"place", {{"line", 0}}}}});
  };
  slow.faults = fault("E-example-timeout", "the program still ran after 10 s, and was stopped");
  kept().keep("a1", slow);
  EXPECT_FALSE(fs::exists(folder_.path() / "results/verdicts/a1.json"));
  write("verdicts/a1.json", judgement_json(slow).dump());  // as earlier versions did
  EXPECT_FALSE(kept().find("a1", grade()));
  slow.faults = fault("E-example-throws", "the program threw std::out_of_range: at");
  kept().keep("a1", slow);
  EXPECT_TRUE(kept().find("a1", grade()));
}

TEST_F(KeptVerdictsTest, AreNothingWithoutAFolder) {
  const KeptVerdicts none("", folder_.path());
  EXPECT_EQ(none.seed("7", false), "7");
  none.keep("a1", grade());
  EXPECT_FALSE(none.find("a1", grade()));
}

TEST_F(KeptVerdictsTest, HaveTheSeedOfTheEarlierRun) {
  EXPECT_EQ(kept().seed("7", false), "7");
  EXPECT_EQ(kept().seed("8", false), "7");
  EXPECT_EQ(kept().seed("9", true), "9");
  EXPECT_EQ(kept().seed("8", false), "9");
}

TEST_F(KeptVerdictsTest, HaveNoSeedThatIsNone) {
  for (const std::string odd : {"", "0", "-1", "1234567890", "7 ::error::", "\x1b[2J", "7\r"}) {
    write("seed", odd + "\n");
    EXPECT_EQ(kept().seed("8", false), "8") << odd;
  }
  write("seed", std::string(5 << 20, '7'));
  EXPECT_EQ(kept().seed("8", false), "8");
}

TEST_F(KeptVerdictsTest, AreNoneWhereTheyAreDamaged) {
  const std::string deep = std::string(300000, '[') + std::string(300000, ']');
  for (const std::string& odd : {std::string("{"), std::string("[]"), deep,
                                 "{\"faults\":" + deep + "}", std::string(5 << 20, ' ') + "{}"}) {
    write("verdicts/a1.json", odd);
    EXPECT_FALSE(kept().find("a1", grade())) << odd.substr(0, 20);
  }
  fs::remove(folder_.path() / "results/verdicts/a1.json");
  fs::create_directory(folder_.path() / "results/verdicts/a1.json");
  EXPECT_FALSE(kept().find("a1", grade()));
}

}  // namespace
}  // namespace mjcourse
