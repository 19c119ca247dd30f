#include "toolchain/warm_objects.h"

#include <warm_eigen.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "base/files.h"
#include "base/out_folder.h"
#include "base/temporary_folder.h"
#include "toolchain/compiler_output.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Made = std::optional<PreparedFolders::Made>;

constexpr const char* kHeaderRule = "dependencies";

// Programs are compiled fast, and yet compute fast, as what takes time in them is mostly Eigen's
// code, from here: made once, it can take seven seconds more.
constexpr const char* kObjectLevel = "-O1";

std::string source_of(const std::vector<std::string>& roots, Warmth warmth) {
  std::string text;
  for (const std::string& root : roots) text += "#include <" + root + ">\n";
  if (warmth == Warmth::thorough) text += kWarmEigen;
  return text;
}

std::vector<std::string> with(std::vector<std::string> command,
                              std::initializer_list<std::string> more) {
  command.insert(command.end(), more);
  return command;
}

// A compilation with its dependencies, which has to be silent. What is wrong with the headers is
// known by its place; a full disk has none, and may have room the next time.
Made compile(const std::vector<std::string>& command, const fs::path& folder,
             const std::vector<fs::path>& reads) {
  const Outcome outcome = run_tool(with(command, {"-MD", "-MF", kHeaderRule}), folder, reads);
  const bool silent = succeeded(outcome) && outcome.err.empty();
  if (!silent && parse_messages(outcome.err).empty()) return std::nullopt;
  const auto rule = DiskFiles(folder).read(kHeaderRule);
  if (!rule) return std::nullopt;
  return PreparedFolders::Made{silent, parse_dependencies(*rule, folder)};
}

// The code of all that is inline in the header `pch`, as `object`.
bool make_object(const std::string& compiler, const fs::path& pch, const fs::path& object,
                 const fs::path& folder, const std::vector<fs::path>& reads) {
  // Some of what is inline in the standard library its own objects keep to themselves. Nobody calls
  // it; whatever else is missing stays an error. (A tool may not write into another's file.)
  const std::string strong = folder / "strong.o";
  return succeeded(run_tool({compiler, kObjectLevel, "-c", pch, "-o", strong}, folder, reads)) &&
         succeeded(run_tool({"objcopy", "--wildcard", "--weaken-symbol=_ZNSt*",
                             "--weaken-symbol=_ZNKSt*", strong, object},
                            folder, reads));
}

}  // namespace

WarmObjects::WarmObjects(Toolchain toolchain, std::optional<fs::path> prepared,
                         const IncludeFolders& include)
    : toolchain_(std::move(toolchain)),
      include_(include),
      headers_(include),
      contents_(headers_.contents()),
      prepared_(std::move(prepared),
                [this](const std::string& path) { return headers_.true_path(path); }) {}

// All that an entry depends on besides the contents of the system's files. All headers of the
// course belong to it, as a new one may hide another.
std::string WarmObjects::request(const std::string& what) const {
  return what + "\n" + toolchain_.compiler + "\n" + toolchain_.full_version + "\n" +
         compile_flags(false) + "\n" + kObjectLevel + "\n" + contents_;
}

WarmObjects::Entry WarmObjects::header(const std::vector<std::string>& roots) {
  if (roots.empty() || !toolchain_.is_clang()) return nullptr;
  for (const Warmth warmth : {Warmth::thorough, Warmth::quick}) {
    if (Entry entry = prepared_.find(request(source_of(roots, warmth)))) return entry;
  }
  return nullptr;
}

void WarmObjects::make_header(const std::vector<std::string>& roots, Warmth warmth) {
  if (roots.empty() || !toolchain_.is_clang()) return;
  const std::string text = source_of(roots, warmth);
  prepared_.get(request(text), [&](const fs::path& kept, const fs::path& staging) -> Made {
    const TemporaryFolder work;
    const fs::path source = kept / "header.hpp", pch = work.path() / "header.pch",
                   object = work.path() / "header.o", overlay = work.path() / "overlay.json";
    OutFolder(kept).write("header.hpp", text);  // clang looks for it whenever the header is used
    write_file(overlay, headers_.overlay(source));
    std::vector<fs::path> reads = read_for(include_);
    reads.push_back(kept);
    std::vector<std::string> command =
        with(toolchain_.command(false, headers_.shown()),
             {"-ivfsoverlay", overlay, "-x", "c++-header", CourseHeaders::kSource, "-o", pch,
              "-fpch-instantiate-templates", "-Xclang", "-fno-pch-timestamp"});
    if (warmth == Warmth::thorough) command.emplace_back("-fpch-codegen");
    Made made = compile(command, work.path(), reads);
    if (!made || headers_.contents() != contents_) return std::nullopt;
    std::erase(made->inputs, CourseHeaders::kSource);
    if (!made->worked) return made;
    if (warmth == Warmth::thorough) {
      if (!make_object(toolchain_.compiler, pch, object, work.path(), reads)) return std::nullopt;
      fs::copy_file(object, staging / "header.o");
    }
    fs::copy_file(pch, staging / "header.pch");
    return made;
  });
}

WarmObjects::Entry WarmObjects::handlers() {
  if (handlers_source(include_).empty() || !toolchain_.is_clang()) return nullptr;
  return prepared_.get(request("handlers"), [&](const fs::path&, const fs::path& staging) -> Made {
    const TemporaryFolder work;
    const fs::path source = work.path() / "handlers.cpp", object = work.path() / "handlers.o",
                   overlay = work.path() / "overlay.json";
    write_file(source, "#include <mjcourse/handlers.cpp>\n");
    write_file(overlay, headers_.overlay(std::nullopt));
    Made made = compile(with(toolchain_.command(false, headers_.shown()),
                             {"-ivfsoverlay", overlay, "-c", source, "-o", object}),
                        work.path(), read_for(include_));
    if (!made || headers_.contents() != contents_) return std::nullopt;
    std::erase(made->inputs, source.string());
    if (made->worked) fs::copy_file(object, staging / "handlers.o");
    return made;
  });
}

}  // namespace mjcourse
