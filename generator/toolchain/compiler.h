// The C++ compiler of the examples: clang-16, or what is found.
//
// Enter with Compiler::find() and compile(). A program is first tried the fast way: with the warm
// header of what it includes (warm_objects.h), if there is one, with mold, and without the
// compiler's driver (driver_steps.h). Whenever that says anything, be it a warning, the program is
// compiled as its reader would, and what that says counts. So a message is always that of a plain
// compilation, and the fast way only ever saves time.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "toolchain/compiler_output.h"
#include "toolchain/include_folders.h"
#include "toolchain/toolchain.h"
#include "toolchain/warm_objects.h"

namespace mjcourse {

struct Compiled {
  bool succeeded = false;
  std::vector<CompilerMessage> messages;
  std::string raw;  // everything the compiler and the linker said
  // Why it gave no answer: "still ran after 120 s, and was stopped"; empty where it gave one.
  std::string stopped;
  bool crashed = false;  // then the compiler gave none of its own accord
  // Every file that was read for it, but for the program itself: absolute paths, sorted; nothing
  // where the compiler does not tell, as of a program that includes a file that is not there. What
  // came by the warm header or with the handlers stands in their `inputs`, lists that all programs
  // with them share (null: there are none). A file of the same name that is added to an
  // include folder later may hide one of these.
  std::optional<std::vector<std::string>> dependencies{std::in_place};
  WarmObjects::Entry header, handlers;

  // Did the compiler itself find something wrong, and not the linker or the clock?
  bool refused() const;
};

class Compiler {
 public:
  // Nothing where no compiler is installed. Its programs have their headers in `include`; what they
  // share is kept in `prepared`, and without a folder not at all.
  static std::optional<Compiler> find(IncludeFolders include,
                                      std::optional<std::filesystem::path> prepared);

  Compiler(Toolchain toolchain, IncludeFolders include,
           std::optional<std::filesystem::path> prepared);

  // "clang 16.0.6", "g++ 12.2.0"
  const std::string& version() const { return toolchain_.version; }

  // Together with the files, all that a program depends on: versions in the tools' own words, and
  // the flags (compile_flags).
  const Toolchain& toolchain() const { return toolchain_; }

  const IncludeFolders& include_folders() const { return include_; }

  // The headers that programs with these roots (warm_header.h) share: can this compiler make and
  // keep one, is one at hand, and make one, which takes a second and up to half a minute.
  bool makes_headers() const;
  bool has_header(const std::vector<std::string>& roots) const;
  void make_header(const std::vector<std::string>& roots, Warmth warmth) const;

  // Compile the program `source` against MuJoCo, Eigen and the helper header into `binary`;
  // `folder` is for files in between, and `beside`, where it is none of "", has the headers that
  // stand beside the program. Where it is not `ours`, none of the course's examples is in reach,
  // but for what these two folders and the include folders have. Safe to call from several threads.
  Compiled compile(const std::filesystem::path& source, const std::filesystem::path& binary,
                   const std::filesystem::path& folder, bool optimize = false,
                   const std::filesystem::path& beside = {}, bool ours = true) const;

  // The preprocessor's output; it takes nothing from a warm header. Nothing where it fails.
  std::optional<std::string> preprocess(const std::filesystem::path& source,
                                        const std::filesystem::path& folder, bool optimize = false,
                                        const std::filesystem::path& beside = {},
                                        bool ours = true) const;

 private:
  struct Program;
  Compiled attempt(const Program& program, const WarmObjects::Entry& header,
                   const WarmObjects::Entry& handlers, bool fast) const;
  std::vector<std::string> command_of(const Program& program,
                                      const WarmObjects::Entry& header) const;

  Toolchain toolchain_;
  IncludeFolders include_;
  std::shared_ptr<WarmObjects> warm_;
};

}  // namespace mjcourse
