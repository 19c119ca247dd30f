#include "evaluate/claims/claim_text.h"

#include <algorithm>
#include <vector>

#include "base/counted.h"
#include "base/running_text.h"
#include "evaluate/answers/proof_text.h"

namespace mjcourse {
namespace {

constexpr std::size_t kLongest = 100;  // bytes of a title

// What came of trying each option or item.
std::string held(const Question& question, const ProofResult& proof) {
  if (question.kind == Question::Kind::order) return "the items come to " + proof.value;
  std::vector<std::string> letters;
  for (const std::size_t i : question.right) letters.emplace_back(1, static_cast<char>('A' + i));
  return listed(letters) + (letters.size() == 1 ? " holds" : " hold") + ", and no other";
}

}  // namespace

std::string as_title(const std::string& text) {
  const std::string line = with_single_blanks(text);
  return line.size() <= kLongest ? line : beginning_of(line, kLongest) + " …";
}

std::string how_run(const Example& program, const Versions& versions) {
  std::string text = "compiled by " + versions.compiler;
  if (!program.compiles) return text + ", which refuses it, as the lesson says";
  text += program.optimize ? " with -O2 and run" : " without optimisation and run";
  for (std::size_t i = 0; i < program.arguments.size(); ++i) {
    text += (i == 0 ? " with " : " ") + program.arguments[i];
  }
  return text + "; exit code " + std::to_string(program.exit_code);
}

std::string how_tried(const ExerciseResult& result) {
  const std::size_t checks = result.checks.size() + result.hidden.size();
  const std::size_t mistakes = result.trials.size() - 1;
  std::string text = "the solution passes " + counted(checks, "check") + ", the starter fails " +
                     std::to_string(result.trials.front().fails.size());
  if (mistakes > 0) {
    text +=
        "; " + counted(mistakes, "wrong variant") +
        (mistakes == 1 ? " fails the check that refuses it" : " fail the check that refuses each");
  }
  return text + (result.runs_in_page() ? "; natively and on the page's engine" : "; natively");
}

std::string how_run(const Snippet& snippet, const Versions& versions) {
  return "compiled by " + versions.compiler + " as the body of a function, and run by itself on " +
         snippet.model.text + ".xml in its initial state; exit code 0";
}

std::string how_run(const Commands& commands) {
  std::vector<std::string> files;
  for (const LocatedText& file : commands.files) files.push_back(file.text);
  return "run by a shell in a folder that has " +
         (files.empty() ? "nothing of the course" : listed(files) + " of the course alone") +
         "; exit code 0 of each";
}

std::string how_run_in_page() {
  return "compiled as a reader's page does it and run on the page's engine; its output and its "
         "records are those of the native run";
}

std::string limits_of_run(double seconds) {
  return number_text(seconds) + " s, 1 MiB of output, no input, a folder of its own";
}

std::string how_compared(const Output& output, const OutputResult& result,
                         const std::string& printed_by) {
  return "compared with what " + printed_by + " printed: " + counted(result.lines, "line") +
         ", numbers to " +
         (output.tolerance ? "within " + number_text(*output.tolerance)
                           : "one unit in their last place");
}

std::string how_rehearsed(const Lab& lab, const LabResult& result) {
  std::vector<std::string> parts{counted(result.runs.size(), "run") + " of 2 s"};
  const auto add = [&](std::size_t count, const char* noun) {
    if (count > 0) parts.push_back(counted(count, noun));
  };
  add(lab.readouts.size(), "readout");
  std::size_t traces = 0;
  for (const Lab::Plot& plot : lab.plots) traces += plot.traces.size();
  add(traces, "trace");
  add(lab.tasks.size(), "task");
  std::string text = "rehearsed: ";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : ", ") + parts[i];
  if (result.predicted)
    text += "; what the reader predicts came to " + number_text(*result.predicted);
  if (lab.goal) text += "; the goal was reached by its solution, and not without";
  return text;
}

std::string how_drawn(const Figure& figure, const Versions& versions) {
  std::string text = "drawn by MuJoCo " + versions.mujoco;
  if (figure.from) {
    text += ", as " + figure.from->example.text + ".cpp recorded it";
  } else if (figure.seconds > 0) {
    text += " after " + number_text(figure.seconds) + " s";
  }
  if (figure.animation) text += ", " + number_text(figure.animation->seconds) + " s on film";
  if (!figure.pin.text.empty()) text += "; to the eye, the reference picture";
  return text;
}

std::string how_plotted(const Plot& plot, const PlotResult& result) {
  const std::size_t rows = result.table.front().values.size();
  return "drawn by Vega from " + counted(rows, "row") + " that " + plot.example.text +
         ".cpp reported as \u201c" + plot.table.text + "\u201d";
}

std::string how_proved(const Question& question, const QuestionResult& result) {
  std::string text;
  for (const ProofResult& proof : result.proofs) {
    if (!text.empty()) text += "; ";
    if (proof.expression.empty()) {
      text += "simulated with " + proof.built + ": " + held(question, proof);
    } else if (proof.built.ends_with(".cpp")) {
      text += "reported by " + proof.built + ": " + proof.expression + " = " + proof.value;
    } else {
      text += proof.built + " was built: " + proof.expression + " = " + proof.value;
    }
  }
  return text;
}

std::string limits_of_answer(const Question& question) {
  const Tolerance& tolerance = question.tolerance;
  if (question.kind != Question::Kind::numeric || tolerance.amount == 0) return "";
  if (tolerance.relative) return "to within " + number_text(100 * tolerance.amount) + " %";
  return "to within " + number_text(tolerance.amount) +
         (question.unit.empty() ? "" : " " + question.unit);
}

}  // namespace mjcourse
