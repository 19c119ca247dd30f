// The C++ compiler of the examples: clang-16, or what is found.
//
// Enter with Compiler::find() and compile(). A program is first tried the fast way: with the warm
// header of what it includes (warm_header.h), compiled once, with mold, and without the compiler's
// driver (driver_steps.h). Whenever that says anything, be it a warning, the program is compiled as
// its reader would, and what that says counts. So a message is always that of a plain compilation,
// and the fast way only ever saves time.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evaluate/compiler_output.h"
#include "evaluate/include_folders.h"
#include "evaluate/toolchain.h"
#include "evaluate/warm_objects.h"
#include "report/diagnostic.h"

namespace mjcourse {

struct Compiled {
  bool succeeded = false;
  std::vector<CompilerMessage> messages;
  std::string raw;  // everything the compiler and the linker said
  // Why it gave no answer: "still ran after 120 s, and was stopped"; empty where it gave one.
  std::string stopped;
  // Every file that was read for it, but for the program itself: absolute paths, sorted; nothing
  // where the compiler does not tell, as of a program that includes a file that is not there. What
  // came by the warm header or with the handlers stands in their `inputs`, lists that all programs
  // with them share (null: there are none). A file that is added to an include folder later may
  // hide one of these.
  std::optional<std::vector<std::string>> dependencies{std::in_place};
  WarmObjects::Entry header, handlers;

  // Did the compiler itself find something wrong, and not the linker or the clock?
  bool refused() const;
};

class Compiler {
 public:
  // Nothing where no compiler is installed. What programs share is kept in the user's cache.
  // `helper` is the folder with the helper header for a course without one; it may be empty.
  static std::optional<Compiler> find(std::filesystem::path helper);

  // The same with another folder for what programs share; nothing is kept without one.
  Compiler(Toolchain toolchain, std::optional<std::filesystem::path> cache,
           std::filesystem::path helper = {});

  // "clang 16.0.6", "g++ 12.2.0"
  const std::string& version() const { return toolchain_.version; }

  // Together with the files, all that a program depends on: versions in the tools' own words, and
  // the flags (compile_flags).
  const Toolchain& toolchain() const { return toolchain_; }

  // Make what programs with these roots (warm_header.h) share, as the first of them would.
  void prepare(const std::vector<std::string>& roots, const std::filesystem::path& examples) const;

  // Compile the program `source` of the course with these `examples` against MuJoCo, Eigen and the
  // helper header into `binary`; `folder` is for files in between. Safe to call from several
  // threads; all but the first wait for a warm header that is being made.
  Compiled compile(const std::filesystem::path& source, const std::filesystem::path& examples,
                   const std::filesystem::path& binary, const std::filesystem::path& folder,
                   bool optimize = false) const;

 private:
  struct Program;
  Compiled attempt(const Program& program, const WarmObjects::Entry& header,
                   const WarmObjects::Entry& handlers, bool fast) const;

  Toolchain toolchain_;
  std::filesystem::path helper_;
  std::shared_ptr<WarmObjects> warm_;
};

// There is none; without a place.
Diagnostic no_compiler();

}  // namespace mjcourse
