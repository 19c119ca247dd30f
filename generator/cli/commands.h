// The commands: each takes its options and gives the exit code.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/parallel.h"
#include "cli/kept_results.h"

namespace mjcourse {

// How `check` says on stdout what it found.
enum class Format { text, json, github, sarif, junit };

struct Options {
  std::filesystem::path course = ".";
  bool course_named = false;  // by --course
  std::filesystem::path out;
  std::string base_url;            // of build: where its site is published; "" as course.yaml says
  std::vector<std::string> where;  // lessons, or lines of them; none: all. Of `new`: what, and how
                                   // it is called
  bool dry_run = false;
  std::filesystem::path report;  // a folder for the report; empty for none
  bool compress = false;         // the site's files also as servers send them
  bool strict = false;           // nothing without proof or reason, and no warnings
  std::filesystem::path store;   // of results; empty for the user's
  std::size_t jobs = core_count();
  Format format = Format::text;
  bool timings = false;
  std::filesystem::path trace;      // a file for them; empty for none
  std::uintmax_t keep = kMostKept;  // bytes that a pruned store keeps
  std::optional<int> port;          // of the preview; nothing: the first that is free
  bool open = false;                // the preview in a browser
  bool without_landlock = false;    // run a course's programs where the kernel has none
  std::string link = "vscode://file{file}:{line}:{column}";  // how a page opens an editor
};

// Evaluate the course and replace the site; with errors the old site stays.
int build(const Options& options);
// Show the course in a browser while it is being written, until Ctrl-C.
int preview(const Options& options);
// Answer an editor that speaks the Language Server Protocol, until it ends.
int lsp(const Options& options);
// Evaluate the course and report.
int check(const Options& options);

// Say what results depend on, and whether they would be used again. Works nothing out.
int explain(const Options& options);
// Begin a level, a lesson, a model or an example of the course: `new KIND NAME`.
int make_new(const Options& options);
// Begin a course: `init DIR`.
int init(const Options& options);
// Say how each lesson stands: its words, minutes, claims, and when it was changed.
int list(const Options& options);
// Say what this machine has of all that courses need.
int doctor(const Options& options);
// `store prune`.
int store(const Options& options);

// Evaluate the course and write what was computed where something else is committed.
int accept(const Options& options);

}  // namespace mjcourse
