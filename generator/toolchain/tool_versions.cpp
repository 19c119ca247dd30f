#include "toolchain/tool_versions.h"

#include <sys/stat.h>

#include <sstream>
#include <system_error>

#include "base/files.h"
#include "base/replace_file.h"
#include "base/sha256.h"
#include "process/find_program.h"
#include "process/open_to_all.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// All that changes with the file behind `path`; empty where there is none.
std::string status_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return "";
  std::ostringstream text;
  text << path.string() << ' ' << status.st_dev << ' ' << status.st_ino << ' ' << status.st_size
       << ' ' << status.st_mtim.tv_sec << '.' << status.st_mtim.tv_nsec << ' '
       << status.st_ctim.tv_sec << '.' << status.st_ctim.tv_nsec;
  return text.str();
}

// `tool` is the user's, wherever that has it: a sandbox looks in the system's folders alone.
std::optional<std::string> ask(const fs::path& tool) {
  Command command;
  command.arguments = {tool.string(), "--version"};
  command.sandbox = Sandbox{};  // it reads itself, and writes nothing
  command.sandbox->read = {tool.string()};
  command.sandbox->reads_all = !can_be_read_by_all(tool);
  const Outcome outcome = run(command);
  if (outcome.end != Outcome::End::exited || outcome.code != 0) return std::nullopt;
  return outcome.out.substr(0, outcome.out.find('\n'));
}

}  // namespace

std::optional<std::string> tool_version(const std::string& tool,
                                        const std::optional<fs::path>& cache) {
  const fs::path path = find_program(tool);
  const std::string status = status_of(path);
  if (status.empty()) return std::nullopt;
  if (!cache) return ask(path);
  const std::string name = sha256(status);
  if (const auto noted = read_file(*cache / name)) return *noted;
  std::optional<std::string> version = ask(path);
  if (version) {
    std::error_code none;
    fs::create_directories(*cache, none);
    try {
      replace_file(*cache, name, std::nullopt, *version);
    } catch (const std::exception&) {
      // Then it is asked the next time too.
    }
  }
  return version;
}

}  // namespace mjcourse
