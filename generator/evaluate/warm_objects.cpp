#include "evaluate/warm_objects.h"

#include <warm_eigen.h>

#include <algorithm>
#include <initializer_list>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "evaluate/compiler_output.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using Made = std::optional<PreparedFiles::Made>;

constexpr const char* kHeaderDependencies = "dependencies";

// Programs are compiled fast, and yet compute fast, as what takes time in them is mostly Eigen's
// code, from here: made once, it can take seven seconds more.
constexpr const char* kObjectLevel = "-O1";

// All that an entry depends on besides the contents of files. The names of the course's headers
// belong to it, as a new one may hide another.
std::string request(const std::string& what, const Toolchain& toolchain,
                    const IncludeFolders& include) {
  std::vector<std::string> names;
  std::error_code none;
  for (const fs::path& folder : include) {
    for (const fs::directory_entry& file : fs::recursive_directory_iterator(folder, none)) {
      names.push_back(file.path().string());
    }
  }
  std::sort(names.begin(), names.end());
  std::string text = what + "\n" + toolchain.compiler + "\n" + toolchain.full_version + "\n" +
                     compile_flags(false) + "\n" + kObjectLevel + "\n";
  for (const fs::path& folder : include) text += fs::absolute(folder).string() + "\n";
  for (const std::string& name : names) text += name + "\n";
  return text;
}

std::vector<std::string> with(std::vector<std::string> command,
                              std::initializer_list<std::string> more) {
  command.insert(command.end(), more);
  return command;
}

// A compilation with kHeaderDependencies, which has to be silent. What is wrong with the headers is known
// by its place; a full disk has none, and may have room the next time.
Made compile(const std::vector<std::string>& command, const fs::path& folder,
             const std::vector<fs::path>& reads) {
  const Outcome outcome = run_tool(with(command, {"-MD", "-MF", kHeaderDependencies}), folder, reads);
  const bool silent = succeeded(outcome) && outcome.err.empty();
  if (!silent && parse_messages(outcome.err).empty()) return std::nullopt;
  const auto rule = DiskFiles(folder).read(kHeaderDependencies);
  if (!rule) return std::nullopt;
  return PreparedFiles::Made{silent, parse_dependencies(*rule, folder)};
}

// `source` includes the roots; clang looks for it whenever the header is used.
Made make_header(const Toolchain& toolchain, const IncludeFolders& include, const fs::path& source,
                 const fs::path& staging) {
  const TemporaryFolder work;
  std::vector<fs::path> reads = read_for(include);
  reads.push_back(source.parent_path());
  const std::string header = work.path() / "header.pch", strong = work.path() / "strong.o",
                    object = work.path() / "header.o";
  Made made = compile(
      with(toolchain.command(false, include),
           {"-x", "c++-header", source.string(), "-o", header, "-fpch-instantiate-templates",
            "-fpch-codegen", "-Xclang", "-fno-pch-timestamp"}),
      work.path(), reads);
  if (!made || !made->worked) return made;
  std::erase(made->inputs, source.string());
  // Some of what is inline in the standard library its own objects keep to themselves. Nobody calls
  // it; whatever else is missing stays an error. (A tool may not write into another's file.)
  const bool has_object =
      succeeded(run_tool({toolchain.compiler, kObjectLevel, "-c", header, "-o", strong},
                         work.path(), reads)) &&
      succeeded(run_tool({"objcopy", "--wildcard", "--weaken-symbol=_ZNSt*",
                          "--weaken-symbol=_ZNKSt*", strong, object},
                         work.path(), reads));
  if (!has_object) return std::nullopt;
  fs::copy_file(header, staging / "header.pch");
  fs::copy_file(object, staging / "header.o");
  return made;
}

}  // namespace

WarmObjects::Entry WarmObjects::header(const std::vector<std::string>& roots,
                                       const IncludeFolders& include) {
  if (roots.empty() || !toolchain_.is_clang()) return nullptr;
  std::string text;
  for (const std::string& root : roots) text += "#include <" + root + ">\n";
  text += kWarmEigen;
  return prepared_.get(request(text, toolchain_, include),
                       [&](const fs::path& kept, const fs::path& staging) {
                         write_file(kept / "header.hpp", text);
                         return make_header(toolchain_, include, kept / "header.hpp", staging);
                       });
}

WarmObjects::Entry WarmObjects::handlers(const IncludeFolders& include) {
  const fs::path source = handlers_source(include);
  if (source.empty()) return nullptr;
  return prepared_.get(request("handlers", toolchain_, include),
                       [&](const fs::path&, const fs::path& staging) {
                         const TemporaryFolder work;
                         const fs::path object = work.path() / "handlers.o";
                         Made made = compile(with(toolchain_.command(false, include),
                                                  {"-c", source.string(), "-o", object.string()}),
                                             work.path(), read_for(include));
                         if (made && made->worked) fs::copy_file(object, staging / "handlers.o");
                         return made;
                       });
}

}  // namespace mjcourse
