// The commands: each takes its own options and gives the exit code.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "cli/open_store.h"
#include "evaluate/shard.h"

namespace mjcourse {

// How `check` says on stdout what it found.
enum class Format { text, json, github, sarif, junit };

// What the commands that evaluate a course have in common.
struct CourseOptions {
  std::filesystem::path course = ".";
  std::filesystem::path store;  // of results; empty for the user's
  SharedPlace shared;           // of results, beside that
  std::size_t jobs = core_count();
  bool without_landlock = false;  // run a course's programs where the kernel has none
};

// Those of them that tell what they verified.
struct VerifyOptions : CourseOptions {
  std::filesystem::path report;  // a folder for the report; empty for none
  bool strict = false;           // nothing without proof or reason, and no warnings
  Format format = Format::text;
  bool timings = false;
  std::filesystem::path trace;  // a file for them; empty for none
  Shard shard;                  // of the course
};

struct AcceptOptions : CourseOptions {
  std::vector<std::string> where;  // lessons, or lines of them; none: all
  bool dry_run = false;
};

struct BuildOptions : VerifyOptions {
  std::filesystem::path out;
  std::string base_url;   // where the site is published; "" as course.yaml says
  bool compress = false;  // the site's files also as servers send them
  bool without_solutions = false;
};

struct CheckOptions : VerifyOptions {};

struct DoctorOptions {
  std::filesystem::path store;
  SharedPlace shared;
};

struct ExplainOptions : CourseOptions {
  std::vector<std::string> where;  // as of accept, or messages' names
  bool json = false;               // for `against`, elsewhere
  std::filesystem::path against;   // what another machine wrote so; empty for none
};

// How `grade` says what hand-ins came to.
enum class GradeFormat { text, json, junit, csv };

struct GradeOptions : CourseOptions {
  std::vector<std::string> hand_ins;   // folders
  std::vector<std::string> exercises;  // by name or lesson; none: those that somebody handed in
  GradeFormat format = GradeFormat::text;
  std::filesystem::path results;                // where all is kept; "" for nowhere
  std::optional<std::chrono::sys_seconds> due;  // what is changed later is late
  std::string seed;                             // of the checks' inputs; "" for a new one
};

struct InitOptions {
  std::vector<std::string> words;  // the folder and the title
  std::string ci = "github";       // what checks it (ci_files.h)
};

struct ListOptions : CourseOptions {};

struct LspOptions : CourseOptions {
  bool course_named = false;  // by --course
};

struct NewOptions {
  std::filesystem::path course = ".";
  std::vector<std::string> words;  // what, and how it is called
};

struct PreviewOptions : CourseOptions {
  std::optional<int> port;                                   // nothing: the first that is free
  bool open = false;                                         // in a browser
  std::string link = "vscode://file{file}:{line}:{column}";  // how a page opens an editor
};

struct TryOptions : CourseOptions {
  std::vector<std::string> words;  // the lesson and the exercise
  std::filesystem::path folder;    // where the reader works; empty for one of the exercise's name
  bool once = false;               // judge it, and end
  bool open = false;               // in an editor
};

struct StoreOptions : CourseOptions {
  std::vector<std::string> words;   // "prune", "push", "pull", or "key" and a file
  std::uintmax_t keep = kMostKept;  // bytes that a pruned store keeps
};

// Evaluate the course and replace the site; with errors the old site stays.
int build(const BuildOptions& options);
// Show the course in a browser while it is being written, until Ctrl-C.
int preview(const PreviewOptions& options);
// Answer an editor that speaks the Language Server Protocol, until it ends.
int lsp(const LspOptions& options);
// Evaluate the course and report.
int check(const CheckOptions& options);

// Say what results depend on, and whether they would be used again. Works nothing out.
int explain(const ExplainOptions& options);
// Begin a level, a lesson, a model, an example or an exercise of the course: `new KIND NAME`.
int make_new(const NewOptions& options);
// Begin a course: `init DIR`.
int init(const InitOptions& options);
// Say how each lesson stands: its words, minutes, claims, and when it was changed.
int list(const ListOptions& options);
// Say what this machine has of all that courses need.
int doctor(const DoctorOptions& options);
// `store prune`, `store push` and `store pull`.
int store(const StoreOptions& options);

// Write an exercise into a folder and judge it after each save.
int try_exercise(const TryOptions& options);
// Judge hand-ins.
int grade(const GradeOptions& options);

// Evaluate the course and write what was computed where something else is committed.
int accept(const AcceptOptions& options);

}  // namespace mjcourse
