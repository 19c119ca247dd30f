#include "evaluate/claims/claim_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const Versions kVersions{"0.1.0", "2.2.2", "clang 16.0.6", "", ""};

LocatedText text(const std::string& bytes) {
  return {bytes, {}};
}

TEST(ClaimText, IsOneLineThatIsCutAtAWord) {
  EXPECT_EQ(as_title("How many\n  joints?"), "How many joints?");
  const std::string long_word(60, 'x');
  EXPECT_EQ(as_title(long_word + " " + long_word + " end"), long_word + " …");
  EXPECT_EQ(as_title(std::string(100, 'x')), std::string(100, 'x'));
}

TEST(ClaimText, SaysHowAProgramWasRun) {
  Example program;
  EXPECT_EQ(how_run(program, kVersions),
            "compiled by clang 16.0.6 without optimisation and run; exit code 0");
  program.optimize = true;
  program.arguments = {"3", "-v"};
  program.exit_code = 2;
  EXPECT_EQ(how_run(program, kVersions),
            "compiled by clang 16.0.6 with -O2 and run with 3 -v; exit code 2");
  program.compiles = false;
  EXPECT_EQ(how_run(program, kVersions),
            "compiled by clang 16.0.6, which refuses it, as the lesson says");
}

TEST(ClaimText, SaysHowASnippetAndCommandsWereRun) {
  Snippet snippet;
  snippet.model = text("swing");
  EXPECT_EQ(how_run(snippet, kVersions),
            "compiled by clang 16.0.6 as the body of a function, and run by itself on swing.xml in "
            "its initial state; exit code 0");
  Commands commands;
  EXPECT_EQ(how_run(commands),
            "run by a shell in a folder that has nothing of the course; exit code 0 of each");
  commands.files = {text("examples"), text("models")};
  EXPECT_EQ(how_run(commands),
            "run by a shell in a folder that has examples and models of the course alone; exit "
            "code 0 of each");
  EXPECT_EQ(limits_of_run(2.5), "2.5 s, 1 MiB of output, no input, a folder of its own");
}

TEST(ClaimText, SaysHowAnOutputWasCompared) {
  Output output;
  EXPECT_EQ(how_compared(output, {1}, "say.cpp"),
            "compared with what say.cpp printed: 1 line, numbers to one unit in their last place");
  output.tolerance = 0.01;
  EXPECT_EQ(how_compared(output, {3}, "the snippet above"),
            "compared with what the snippet above printed: 3 lines, numbers to within 0.01");
}

TEST(ClaimText, SaysHowALabWasRehearsed) {
  Lab lab;
  LabResult result;
  result.runs.resize(1);
  EXPECT_EQ(how_rehearsed(lab, result), "rehearsed: 1 run of 2 s");
  result.runs.resize(3);
  lab.readouts.resize(2);
  lab.plots.resize(2);
  lab.plots[0].traces.resize(2);
  lab.plots[1].traces.resize(1);
  lab.tasks.resize(1);
  lab.goal = Lab::Goal();
  result.predicted = 0.5;
  EXPECT_EQ(how_rehearsed(lab, result),
            "rehearsed: 3 runs of 2 s, 2 readouts, 3 traces, 1 task; what the reader predicts came "
            "to 0.5; the goal was reached by its solution, and not without");
}

TEST(ClaimText, SaysHowAPictureWasDrawn) {
  Figure figure;
  EXPECT_EQ(how_drawn(figure, kVersions), "drawn by MuJoCo 2.2.2");
  figure.seconds = 0.5;
  figure.animation = Figure::Animation{2, 30, {}};
  EXPECT_EQ(how_drawn(figure, kVersions), "drawn by MuJoCo 2.2.2 after 0.5 s, 2 s on film");
  figure.from = Figure::Snapshot{text("say"), text("end")};
  figure.animation.reset();
  figure.pin = text("swing");
  EXPECT_EQ(how_drawn(figure, kVersions),
            "drawn by MuJoCo 2.2.2, as say.cpp recorded it; to the eye, the reference picture");
}

TEST(ClaimText, SaysHowAnAnswerWasProved) {
  Question question;
  QuestionResult result;
  result.proofs = {{"swing.xml", "model.nq", "2"}, {"say.cpp", "nq", "2"}};
  EXPECT_EQ(how_proved(question, result),
            "swing.xml was built: model.nq = 2; reported by say.cpp: nq = 2");
  question.kind = Question::Kind::mcq;
  question.right = {1};
  result.proofs = {{"swing.xml", "", ""}};
  EXPECT_EQ(how_proved(question, result), "simulated with swing.xml: B holds, and no other");
  question.kind = Question::Kind::multi;
  question.right = {0, 2, 3};
  EXPECT_EQ(how_proved(question, result),
            "simulated with swing.xml: A, C and D hold, and no other");
  question.kind = Question::Kind::order;
  result.proofs = {{"swing.xml", "", "1 < 2"}};
  EXPECT_EQ(how_proved(question, result), "simulated with swing.xml: the items come to 1 < 2");
}

TEST(ClaimText, SaysHowFarAnAnswerMayBeOff) {
  Question question;
  EXPECT_EQ(limits_of_answer(question), "");
  question.tolerance.amount = 0.05;
  EXPECT_EQ(limits_of_answer(question), "to within 0.05");
  question.unit = "m/s";
  EXPECT_EQ(limits_of_answer(question), "to within 0.05 m/s");
  question.tolerance.relative = true;
  EXPECT_EQ(limits_of_answer(question), "to within 5 %");
  question.kind = Question::Kind::mcq;
  EXPECT_EQ(limits_of_answer(question), "");
}

}  // namespace
}  // namespace mjcourse
