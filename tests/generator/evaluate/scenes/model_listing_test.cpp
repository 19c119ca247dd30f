#include "evaluate/scenes/model_listing.h"

#include <gtest/gtest.h>

#include "evaluate/evaluation_of.h"

namespace mjcourse {
namespace {

TEST(ModelExcerpt, IsPartOfItsModel) {
  const EvaluationOf found("```xml model=ball\n<worldbody>\n  <!-- … -->\n</worldbody>\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().listed_models, 1);
}

TEST(ModelExcerpt, ThatIsNotInItsModelIsShownBesideIt) {
  EXPECT_EQ(
      evaluated_mistakes("> ```xml model=ball\n>   <actuator><motor name=\"moto\" "
                         "joint=\"slide\"/></actuator>\n> ```\n"),
      R"(content/1-a/1.1-x.md:5:5: error: this line is not in models/ball.xml, or not here [E-excerpt-differs]
  5 | >   <actuator><motor name="moto" joint="slide"/></actuator>
    |     ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  note: models/ball.xml:6:3: the file has
  6 |   <actuator><motor name="motor" joint="slide"/></actuator>
    |   ^~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~~
  cure: copy it from there; a line `…` stands for lines left out
)");
}

TEST(ModelExcerpt, MustShowSomethingOfAModelThatIsThere) {
  EXPECT_EQ(evaluated_mistakes("```xml model=ball\n```\n"),
            R"(content/1-a/1.1-x.md:4:1: error: this excerpt shows nothing [E-excerpt-empty]
  4 | ```xml model=ball
    | ^~~~~~~~~~~~~~~~~
  cure: copy lines of models/ball.xml into it
)");
  EXPECT_EQ(
      evaluated_mistakes("```xml model=bal\n<mujoco>\n```\n"),
      R"(content/1-a/1.1-x.md:4:14: error: there is no model `bal` in models/ [E-model-unknown]
  4 | ```xml model=bal
    |              ^~~
  cure: did you mean `ball`?
)");
}

TEST(InlineModel, MustCompile) {
  const EvaluationOf found("```xml mjcf\n<mujoco/>\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.tally().listed_models, 1);
  EXPECT_EQ(found.result<ModelResult>().refusal, "");
  EXPECT_EQ(
      evaluated_mistakes("> ```xml mjcf\n> <mujoco>\n>   <option timestpe=\"1\"/>\n> "
                         "</mujoco>\n> ```\n"),
      R"(content/1-a/1.1-x.md:6:13: error: element 'option': unrecognized attribute: 'timestpe' [E-model-mjcf]
  6 | >   <option timestpe="1"/>
    |             ^~~~~~~~
  cure: did you mean `timestep`?
)");
}

TEST(InlineModel, MayBeOneThatDoesNotCompile) {
  const EvaluationOf found(
      "```xml mjcf expect=error\n<mujoco>\n  <option timestpe=\"1\"/>\n</mujoco>\n```\n");
  EXPECT_EQ(found.mistakes(), "");
  EXPECT_EQ(found.result<ModelResult>().refusal,
            "line 2: element 'option': unrecognized attribute: 'timestpe'\n");
  EXPECT_EQ(
      evaluated_mistakes("```xml mjcf expect=error\n<mujoco/>\n```\n"),
      R"(content/1-a/1.1-x.md:4:1: error: the model compiles, but the lesson says that it does not [E-model-compiles]
  4 | ```xml mjcf expect=error
    | ^~~~~~~~~~~~~~~~~~~~~~~~
  cure: remove `expect=error`, or correct what the lesson says
)");
}

}  // namespace
}  // namespace mjcourse
