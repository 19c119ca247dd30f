#include "lesson/blocks/read_model_fence.h"

#include <gtest/gtest.h>

#include "reading_of.h"

namespace mjcourse {
namespace {

TEST(ReadModelFence, TakesAnExcerpt) {
  const ReadingOf reading = reading_of("```xml model=ball\n<geom/>\n```\n");
  EXPECT_EQ(reading.mistakes(), "");
  EXPECT_EQ(reading.only<ModelExcerpt>().model.text, "ball");
  EXPECT_EQ(reading.only<ModelExcerpt>().text.text, "<geom/>\n");
}

TEST(ReadModelFence, TakesAModel) {
  EXPECT_TRUE(reading_of("```xml mjcf\n<mujoco/>\n```\n").only<InlineModel>().compiles);
  EXPECT_FALSE(reading_of("```xml mjcf expect=error\n<m/>\n```\n").only<InlineModel>().compiles);
}

TEST(ReadModelFence, MustSayWhichOfTheTwoItIs) {
  EXPECT_EQ(
      mistakes_in("```xml\n<mujoco/>\n```\n"),
      R"(content/1-a/1.1-x.md:4:1: error: a plain `xml` fence would show a model that nobody compiled [E-fence-kind]
  4 | ```xml
    | ^~~~~~
  cure: name the model that this is a part of: `xml model=NAME`; or let it be a whole one: `xml mjcf`; or say that nobody compiles it, and why: `xml unchecked because="…"`
)");
  EXPECT_EQ(mistakes_in("```xml mjfc\n<mujoco/>\n```\n"),
            R"(content/1-a/1.1-x.md:4:8: error: there is no fence `xml mjfc` [E-fence-kind]
  4 | ```xml mjfc
    |        ^~~~
  cure: did you mean `mjcf`?
)");
}

TEST(ReadModelFence, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(mistakes_in("```xml mjcf expect=eror\n```\n"),
            R"(content/1-a/1.1-x.md:4:20: error: `expect` has no such value [E-fence-option]
  4 | ```xml mjcf expect=eror
    |                    ^~~~
  cure: did you mean `error`?
)");
  EXPECT_EQ(
      mistakes_in("```xml model=ball expect=error\n```\n"),
      R"(content/1-a/1.1-x.md:4:19: error: a `xml` fence has no option `expect` [E-fence-option]
  4 | ```xml model=ball expect=error
    |                   ^~~~~~
  cure: known: model
)");
}

}  // namespace
}  // namespace mjcourse
