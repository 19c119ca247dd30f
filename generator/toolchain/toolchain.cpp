#include "toolchain/toolchain.h"

#include <re2/re2.h>

#include <utility>

#include "base/arithmetic.h"
#include "base/cache_folder.h"
#include "process/known_package.h"
#include "toolchain/containment.h"
#include "toolchain/tool_versions.h"

namespace mjcourse {
namespace {

const std::vector<std::string> kFlags{
    "-std=c++20", "-Wall", "-Wextra", "-fno-diagnostics-color", "-isystem", "/usr/include/eigen3"};

// Optimising mostly costs more than it saves: MuJoCo itself is optimised, and gives the same bits
// however its caller was compiled.
const char* level(bool optimize) {
  return optimize ? "-O2" : "-O0";
}

// A compiler's memory, in large pages and asked for seldom: one of glibc's settings, without which
// clang spends a seventh of its time on 20,000 page faults.
constexpr const char* kLargePages = "glibc.malloc.hugetlb=1:glibc.malloc.top_pad=67108864";

// "clang 16.0.6" of what `NAME --version` prints: "Debian clang version 16.0.6 (15~deb12u1)".
std::string short_version(const std::string& name, const std::string& line) {
  static const RE2 form(R"((\d+\.\d+(?:\.\d+)?))");
  std::string number;
  RE2::PartialMatch(line, form, &number);
  const std::string plain = name.starts_with("clang") ? "clang" : name;
  return number.empty() ? plain : plain + " " + number;
}

}  // namespace

std::optional<Toolchain> Toolchain::find() {
  std::optional<std::filesystem::path> cache = user_cache_folder();
  if (cache) *cache /= "tools";
  for (const char* name : {"clang++-16", "clang++-19", "clang++-14", "clang++", "g++"}) {
    const std::optional<std::string> line = tool_version(name, cache);
    if (!line) continue;
    const std::optional<std::string> mold = tool_version("mold", cache);
    return Toolchain{name, short_version(name, *line), *line,
                     mold ? *mold : tool_version("ld", cache).value_or(""), mold.has_value()};
  }
  return std::nullopt;
}

std::vector<std::string> Toolchain::command(bool optimize, const IncludeFolders& include) const {
  std::vector<std::string> words{compiler, level(optimize)};
  words.insert(words.end(), kFlags.begin(), kFlags.end());
  for (const std::filesystem::path& folder : include) {
    words.push_back("-I" + folder.string());
    words.push_back(file_names_in(folder, "examples/include"));
  }
  return words;
}

std::string file_names_in(const std::filesystem::path& folder, const std::string& name) {
  return "-fmacro-prefix-map=" + folder.string() + "=" + name;
}

std::string compile_flags(bool optimize) {
  std::string text = level(optimize);
  for (const std::string& flag : kFlags) text += " " + flag;
  return text;
}

std::string compiler_package() {
  return known_package({"clang-16", "clang-19"});
}

Outcome run_tool(std::vector<std::string> arguments, const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& reads) {
  Command command;
  command.arguments = std::move(arguments);
  command.folder = folder.string();
  command.environment = {"TMPDIR=" + folder.string(),  // a compiler that is killed leaves files
                         std::string("GLIBC_TUNABLES=") + kOneRounding + ":" + kLargePages};
  command.seconds = kToolSeconds;
  command.sandbox = compiler_sandbox(folder, reads);
  return run(command);
}

bool succeeded(const Outcome& outcome) {
  return outcome.end == Outcome::End::exited && outcome.code == 0;
}

}  // namespace mjcourse
