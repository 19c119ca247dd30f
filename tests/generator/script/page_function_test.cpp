#include "script/page_function.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::vector<std::string> kNames{"model", "data", "Math", "qpos", "step"};

TEST(PageFunction, IsTheAuthorsTextOnLinesOfItsOwn) {
  EXPECT_EQ(page_script("data.qvel[0] = 1;\nstep(2) // and on", kNames),
            "({ data, step }) => { {\ndata.qvel[0] = 1;\nstep(2) // and on\n} }");
  EXPECT_EQ(page_expression("Math.abs(data.time)", kNames),
            "({ data, Math }) => { return (\nMath.abs(data.time)\n); }");
  EXPECT_EQ(page_assignment("qpos('a')[0] // of a", kNames),
            "({ qpos, value }) => { (\nqpos('a')[0] // of a\n) = value; }");
}

TEST(PageFunction, TakesOnlyWhatItsTextNames) {
  EXPECT_EQ(page_expression("1", kNames), "() => { return (\n1\n); }");
  EXPECT_EQ(page_expression("data.qpos[0]", kNames),
            "({ data }) => { return (\ndata.qpos[0]\n); }");
  EXPECT_EQ(page_expression("[...qpos('a')]", kNames),
            "({ qpos }) => { return (\n[...qpos('a')]\n); }");
  EXPECT_EQ(page_expression("mydata + data2 + $data + dataä", kNames),
            "() => { return (\nmydata + data2 + $data + dataä\n); }");
}

}  // namespace
}  // namespace mjcourse
