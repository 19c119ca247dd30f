// NativeProgram: a program of a course, compiled and run as its reader would.
//
//   NativeProgram program({name, file, text}, context);
//   if (auto run = program.find(request)) …          // as it ran before
//   if (program.compile().succeeded) program.run(request);
//
// The text is compiled with `#line`, so that the compiler's complaints name `file`. The program
// runs in an empty folder of its own, with no input, against the clock.
// Tested by tests/generator/actions/native_program_test.cpp.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "actions/action_store.h"
#include "actions/lent_headers.h"
#include "base/temporary_folder.h"
#include "cache/trace.h"
#include "process/subprocess.h"
#include "toolchain/compiler.h"
#include "toolchain/include_folders.h"

namespace mjcourse {

// An action's view of its course. All must outlive it.
struct ActionContext {
  const std::filesystem::path& root;
  const Compiler& compiler;
  ActionStore& store;
  Trace& trace;  // gets what the action looked at
};

struct NativeSource {
  std::string name;  // of the program
  std::string file;  // as the course has it: "examples/l0_1_parabola.cpp"
  std::string text;
  bool optimize = false;
  // A stranger may have written a part of it: its compiler can read the headers beside it that it
  // includes, and no other file of its folder.
  bool handed_in = false;
};

// A listener hears what a program reports, in place of the file of its records.
struct RunListener {
  std::string key;                                      // all that its answers depend on
  std::function<std::string(std::string_view)> answer;  // to a line, as Command::hears
};

struct NativeRequest {
  std::vector<std::string> arguments = {};
  double seconds = 10;    // wall clock
  int exit_code = 0;      // with which it is to end
  std::string seed = {};  // what the helper header's seed() gives; "" for its own
  std::optional<RunListener> listener = {};
  bool is_kept = true;  // may its run be found another time?
};

struct NativeRun {
  Outcome outcome;
  // Its records for the lesson, or what its listener heard; nothing where they are more than 16
  // MiB.
  std::optional<std::string> records;
  double seconds = 0;  // measured, without compiling
  // The files that a reader needs beside it, by the course's names (program_files.h).
  std::vector<std::string> files;
};

class NativeProgram {
 public:
  NativeProgram(NativeSource source, const ActionContext& context);

  const NativeSource& source() const { return source_; }

  // The folder of the program, where that includes headers from there; "" where it does not.
  const std::filesystem::path& beside() const { return beside_; }

  // Both give an earlier result: the run of a program that compiled without a word and ended as it
  // was to end, and the compiler's words of one that did not compile.
  std::optional<NativeRun> find(const NativeRequest& request) const;
  std::optional<std::string> find_refusal() const;

  // At its first call.
  const Compiled& compile();
  // The preprocessor's output. Nothing where it fails.
  std::optional<std::string> preprocessed();
  // After compile(), and what the compiler said.
  std::string refusal();
  // After compile(), which succeeded.
  NativeRun run(const NativeRequest& request);

 private:
  void make_folder();
  std::filesystem::path source_path() const { return folder_->path() / (source_.name + ".cpp"); }
  Dependencies recipe(const std::string& kind,
                      const std::vector<std::string>& arguments = {}) const;
  Dependencies recipe_of(const NativeRequest& request) const;
  Command command_of(const NativeRequest& request, const std::filesystem::path& own,
                     const std::filesystem::path& records) const;

  NativeSource source_;
  const ActionContext context_;
  std::filesystem::path beside_;
  std::optional<LentHeaders> lent_;
  std::chrono::system_clock::time_point begin_;
  Trace compiling_;  // what that looked at
  std::unique_ptr<TemporaryFolder> folder_;
  std::filesystem::path binary_;
  std::optional<Compiled> compiled_;
  int runs_ = 0;
};

}  // namespace mjcourse
