// Results: what was found out about the blocks of a lesson.
//
// One for each block that claims something, under the block's index. Evaluating makes them, writing
// turns them into HTML; nothing here is HTML but a formula's own markup, which is KaTeX's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/blob.h"
#include "findings/plot_drawing.h"
#include "lesson/blocks/lab.h"

namespace mjcourse {

struct FormulaResult {
  std::string markup;
};

// What a program told its lesson by result(), table() and snapshot() of the helper header, by name.
// A whole number that no double holds is one of the last two.
using Reported =
    std::variant<double, std::string, std::vector<double>, std::int64_t, std::uint64_t>;
// The parts of a state by MuJoCo's names of them: "time", "qpos", "mocap_pos" …
using State = std::map<std::string, std::vector<double>>;
struct Column {
  std::string name;
  std::vector<double> values;
};
using Table = std::vector<Column>;  // its columns are equally long
// One of the checks by which a program judges what its reader wrote: expect() of the helper header.
// It may have been made many times; these are the first that failed, or the first of all.
struct Check {
  std::string what;     // what should hold
  bool holds = false;   // each time
  std::string meaning;  // what it means that it does not; may be empty
  std::string found;    // the values of one that does not hold; may be empty
  double points = 1;
  int line = 0;  // of the call, in its file
};
struct Records {
  std::map<std::string, Reported> results;
  std::map<std::string, Table> tables;
  std::map<std::string, State> snapshots;
  std::vector<Check> checks = {};  // in the order in which they were made first
};

// What came of a program in a page, where the reader's compiler made it and the page's engine ran
// it.
struct PageRun {
  // Where the two are not the same text.
  struct Outputs {
    std::string native, page;
  };
  std::string why_not;  // in a clause for readers: why no page runs it. Then the rest is empty
  std::optional<Outputs> outputs = {};
  std::string otherwise = {};  // how else it came out than natively; "" where it did not
};

struct ExampleResult {
  std::string code;    // as a reader sees it
  std::string output;  // its stdout, or what the compiler says of a program that must not compile
  Records records = {};
  double run_seconds = 0;  // measured, without compiling
  // What it was made of and opened, beside itself, as the course has it or would have it:
  // "examples/include/mjcourse/mjcourse.hpp", "models/x.xml". Sorted.
  std::vector<std::string> files = {};
  std::optional<PageRun> page = {};  // nothing where no page's compiler is installed
};

struct ExerciseResult {
  // What a variant of the text fails: "" is the starter.
  struct Trial {
    std::string name;
    std::vector<std::string> fails;
  };
  std::string starter;              // as a reader begins with it
  std::vector<Trial> trials;        // the starter's, and then the mistakes'
  std::vector<std::string> hidden;  // what the hidden checks say of themselves
  std::string why_not = {};         // as PageRun has it
  // Of the solution's run, from where the program is run.
  std::vector<Check> checks = {};
  std::vector<std::string> files = {};
  std::optional<PageRun> page = {};

  bool runs_in_page() const { return page && page->why_not.empty() && why_not.empty(); }
};

struct ValueResult {
  std::string text;    // as the page shows it
  std::string origin;  // "model.nq of joint_zoo.xml"
};

// Of an excerpt or an inline model.
struct ModelResult {
  std::string refusal;  // MuJoCo's, of a model that must not compile
};

// A picture that the author put beside the lesson.
struct ImageResult {
  std::filesystem::path file;  // on the disk
  std::string hash;            // of its bytes
  int width = 0, height = 0;   // pixels, or an SVG's units
};

struct OutputResult {
  int lines = 0;
};

// The same picture in two formats.
struct Poster {
  Blob webp, png;             // files
  int width = 0, height = 0;  // CSS pixels; the picture has two for each of them
};

// A picture held against its pinned reference. A picture that differs is a result like another, so
// that a report can show it. All PNG.
struct PinComparison {
  std::string name;  // as the lesson pins it
  Blob reference;    // empty where there is none that can be read
  Blob actual;       // at the reference's size
  Blob difference;   // empty where the two could not be compared
  bool agrees = false;
};

struct FigureResult {
  Poster poster;  // a film's first picture
  Blob film;      // an MP4 file; empty for a still
  std::optional<PinComparison> pin = {};
};

// What a lab's model is made of, by the names under which MuJoCo finds it without a disk.
struct LabModel {
  std::string main;
  std::map<std::string, std::string> texts;             // MJCF: the main file and its includes
  std::map<std::string, std::filesystem::path> assets;  // files on the disk
};

// What a control was set to: nothing (a button, a keyframe), on or off, an option, a number.
using ControlValue = std::variant<std::monostate, bool, int, double>;

// What a lab's readouts said a number of steps after a control; and of a lab with a ghost, what its
// plots' traces said there of the ghost.
struct LabReading {
  int steps = 0;
  std::vector<double> values;
  std::vector<double> ghost = {};
};

// A run from a reset on which one control acted, or none.
struct LabRunResult {
  std::optional<std::size_t> control;
  ControlValue value;
  std::vector<LabReading> readings;
};

struct LabResult {
  std::vector<double> readouts;             // at the start, in the lab's order
  std::vector<std::vector<double>> traces;  // at the start, for each plot
  Lab::Camera camera;                       // the lab's, or one that shows all of the model
  std::vector<std::string> overlays;        // that are drawn at the start
  std::uint64_t memory = 0;                 // bytes that it takes in a page
  LabModel model;
  std::vector<std::string> script_names;            // what scripts may use of the world
  std::map<std::string, std::string> scripts = {};  // that have guards (lab_scripts.h)
  std::vector<int> keyframes;  // for each control: its keyframe; 0 for what is none
  std::vector<LabRunResult> runs;
  std::optional<double> predicted;  // what the reader is asked to predict
  std::optional<Poster> poster;
  std::optional<PinComparison> pin = {};  // of the poster
};

struct PlotResult {
  PlotDrawings drawings;
  Table table;       // what it shows
  std::string file;  // of the example that reported it
};

// One way in which an answer was found, or the reason why none was needed.
struct ProofResult {
  std::string built;       // "a model with 7 hinge joints", "pick_place.xml", "l1_2_example.cpp"
  std::string expression;  // what was evaluated; empty where each option or item was
  std::string value;       // what it gave; an order's numbers as "1 < 2 < 3"
};

struct QuestionResult {
  bool proved = false;
  std::vector<ProofResult> proofs;
  bool by_program = false;  // all its proofs are results of examples
  std::string because;      // why the answer is only asserted; may be empty
  bool failed = false;      // it is wrong, or a proof is; reported
  double seconds = 0;       // measured
};

struct QuizResult {
  std::vector<QuestionResult> questions;
};

using Result =
    std::variant<FormulaResult, ValueResult, ExampleResult, ExerciseResult, ModelResult,
                 OutputResult, ImageResult, LabResult, FigureResult, PlotResult, QuizResult>;

}  // namespace mjcourse
