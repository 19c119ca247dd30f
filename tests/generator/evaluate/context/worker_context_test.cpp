// Models, as labs and proofs ask for them.
#include "evaluate/context/worker_context.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

std::string lab_on(const std::string& model) {
  return "```lab simlab\n{\"title\": \"T\", \"alt\": \"A.\", \"model\": \"" + model + "\"}\n```\n";
}

TEST(Model, MustBeThere) {
  EXPECT_EQ(
      evaluated_mistakes(lab_on("bal")),
      R"(content/1-a/1.1-x.md:5:39: error: there is no model `bal` in models/ [E-model-unknown]
  5 | {"title": "T", "alt": "A.", "model": "bal"}
    |                                       ^~~
  cure: did you mean `ball`?
)");
}

TEST(Model, ShowsAMistakeInItsFileThereAndOnce) {
  const std::map<std::string, std::string> files{
      {"models/bad.xml",
       "<mujoco>\n  <worldbody>\n    <geom sise='1'/>\n  </worldbody>\n</mujoco>\n"}};
  EXPECT_EQ(
      evaluated_mistakes(lab_on("bad") + "\n" + lab_on("bad"), files),
      R"(models/bad.xml:3:11: error: element 'geom': unrecognized attribute: 'sise' [E-model-mjcf]
  3 |     <geom sise='1'/>
    |           ^~~~
  note: content/1-a/1.1-x.md:5:39: lesson content/1-a/1.1-x.md uses this model
  5 | {"title": "T", "alt": "A.", "model": "bad"}
    |                                       ^~~
  cure: did you mean `size`?
)");
}

TEST(Model, MayStandInTheLessonAndShowsItsMistakesThere) {
  EXPECT_EQ(
      evaluated_mistakes("```quiz\n{\"id\": \"q\", \"questions\": [{\"kind\": \"numeric\", "
                         "\"answer\": 1, \"q\": \"?\",\n  \"verify\": [{\"value\": \"1\", "
                         "\"mjcf\": [\"<mujoco>\", \"<worldbody>\",\n"
                         "    \"  <geom sise='1'/>\", \"</worldbody>\", \"</mujoco>\"]}]}]}\n"
                         "```\n"),
      R"(content/1-a/1.1-x.md:7:14: error: element 'geom': unrecognized attribute: 'sise' [E-model-mjcf]
  7 |     "  <geom sise='1'/>", "</worldbody>", "</mujoco>"]}]}]}
    |              ^~~~
  cure: did you mean `size`?
)");
}

TEST(Model, IsFoundBesideTheFilesThatItIncludes) {
  EXPECT_EQ(
      evaluated_mistakes(
          lab_on("whole"),
          {{"models/whole.xml", "<mujoco><include file='parts/part.xml'/></mujoco>"},
           {"models/parts/part.xml", "<mujoco><worldbody><geom size='1'/></worldbody></mujoco>"}}),
      "");
}

TEST(WorkerContext, SaysWhenTheAssetsAreNotBuilt) {
  EXPECT_THROW(
      {
        try {
          const Course course;
          const MemoryFiles nothing({});
          RunContext(course, ".", nothing).script("world");
        } catch (const std::runtime_error& error) {
          EXPECT_STREQ(
              error.what(),
              "the site's assets are not built: script/world.js: No such file or directory");
          throw;
        }
      },
      std::runtime_error);
}

}  // namespace
}  // namespace mjcourse
