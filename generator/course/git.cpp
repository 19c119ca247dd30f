#include "course/git.h"

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/utf8.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOutput = 64 << 20;  // bytes; the log of some hundred thousand changes
// Of one question. What it is asked for are dates, and nobody waits a minute for these.
constexpr int kSeconds = 10;
// Of a repository besides its objects: branches and tags, of which git packs those that get old.
constexpr std::size_t kMostFilesOfGits = 10'000;
constexpr int kMostDepthOfGits = 100;  // of folders in each other
constexpr std::size_t kMostAlternates = 100;

// The first line of a file, a path or a little more; "" where there is none.
std::string line_of(const fs::path& file) {
  std::error_code none;
  if (!fs::is_regular_file(file, none)) return "";
  std::string line(std::size_t{2} * PATH_MAX, '\0');
  std::ifstream text(file, std::ios::binary);
  text.read(line.data(), std::ssize(line));
  line.resize(static_cast<std::size_t>(text.gcount()));
  return line.substr(0, line.find('\n'));
}

// Would git wait for somebody at its other end, or read it for ever?
bool is_pipe_or_device(const fs::path& file) {
  std::error_code none;
  const fs::file_type type = fs::status(file, none).type();
  return type == fs::file_type::fifo || type == fs::file_type::character ||
         type == fs::file_type::block;
}

// What in a repository's folder would hold git up, or us while we look for it; of its objects, and
// of those of what it holds, there may be hundreds of thousands, so only a time limit knows. Looks
// at `left` files more at most.
std::string find_trouble(const fs::path& folder, std::size_t& left) {
  std::error_code none;
  constexpr auto skip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator file(folder, skip, none), end; !none && file != end;
       file.increment(none)) {
    if (left-- == 0 || file.depth() > kMostDepthOfGits) {
      left = 0;
      return readable(folder.string()) +
             " has too many files besides its objects, or too deep ones";
    }
    if (is_pipe_or_device(file->path())) {
      return readable(file->path().string()) +
             " is a pipe or a device, where git has a file; remove it";
    }
    if (file->path().filename() == "objects") file.disable_recursion_pending();
  }
  return "";
}

// Of a folder's `.git`, which names the repository where it lies elsewhere, as of a work tree or a
// submodule.
fs::path repository_at(const fs::path& folder) {
  constexpr std::string_view key = "gitdir: ";
  fs::path place = folder / ".git";
  std::error_code none;
  if (fs::is_directory(place, none)) return place;
  const std::string line = line_of(place);
  return line.starts_with(key) ? folder / line.substr(key.size()) : fs::path();
}

// Where other repositories keep objects of this one.
void add_alternates(const fs::path& objects, std::vector<std::string>& read) {
  std::istringstream lines(DiskFiles(objects).read("info/alternates").value_or(""));
  const std::size_t most = read.size() + kMostAlternates;
  for (std::string line; read.size() < most && std::getline(lines, line);) {
    if (!line.empty()) read.push_back((objects / line).lexically_normal().string());
  }
}

// The folders that no repository is looked for in from below, as git knows them from the
// environment.
std::vector<fs::path> ceilings() {
  const char* const value = std::getenv("GIT_CEILING_DIRECTORIES");
  std::vector<fs::path> folders;
  std::istringstream names(value == nullptr ? "" : value);
  for (std::string name; std::getline(names, name, ':');) {
    std::error_code none;
    if (name.starts_with('/')) folders.push_back(fs::weakly_canonical(name, none));
  }
  return folders;
}

std::string why_failed(const Outcome& outcome) {
  if (outcome.end == Outcome::End::not_started) return "git is not installed";
  if (outcome.end == Outcome::End::timed_out) {
    return "git does not answer within " + std::to_string(kSeconds) + " s";
  }
  const std::string line = outcome.err.substr(0, outcome.err.find('\n'));
  return line.empty() ? "git fails" : readable(line);
}

}  // namespace

std::optional<Git> Git::find(const fs::path& folder) {
  std::error_code none;
  const fs::path real = fs::canonical(folder, none);
  const std::vector<fs::path> stops = ceilings();
  for (fs::path above = real; !above.empty(); above = above.parent_path()) {
    const fs::path own = repository_at(above);
    if (!own.empty()) {
      const std::string shared = line_of(own / "commondir");
      const fs::path common = (shared.empty() ? own : own / shared).lexically_normal();
      Git git;
      git.folder_ = real;
      git.work_tree_ = above;
      git.own_ = own;
      git.read_ = {above.string(), own.string(), common.string()};
      add_alternates(common / "objects", git.read_);
      std::size_t left = kMostFilesOfGits;
      git.trouble_ = find_trouble(own, left);
      if (git.trouble_.empty() && common != own) git.trouble_ = find_trouble(common, left);
      return git;
    }
    if (above == above.root_path() || std::ranges::count(stops, above.parent_path()) > 0) break;
  }
  return std::nullopt;
}

tl::expected<std::string, std::string> Git::ask(const std::vector<std::string>& arguments) const {
  if (!trouble_.empty()) return tl::unexpected(trouble_);
  Command command;
  // The repository may have any owner: see the header. Where we are root, git is not.
  command.arguments = {"git"};
  for (const char* setting :
       {"safe.directory=*", "safe.bareRepository=explicit", "core.quotePath=false",
        "core.hooksPath=/dev/null", "core.fsmonitor=false", "core.pager=cat",
        "core.packedGitLimit=1g", "log.showSignature=false", "log.showRoot=true"}) {
    command.arguments.insert(command.arguments.end(), {"-c", setting});
  }
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  command.folder = folder_.string();
  command.environment = {"TZ=UTC",
                         "GIT_DIR=" + own_.string(),
                         "GIT_WORK_TREE=" + work_tree_.string(),
                         "GIT_CONFIG_NOSYSTEM=1",
                         "GIT_CONFIG_GLOBAL=/dev/null",
                         "GIT_ATTR_NOSYSTEM=1",
                         "GIT_OPTIONAL_LOCKS=0",
                         "GIT_TERMINAL_PROMPT=0"};
  command.seconds = kSeconds;
  command.output_bytes = kMostOutput;
  command.sandbox = Sandbox{read_, {}};
  command.sandbox->reads_all = true;   // it is no program of the course's
  command.sandbox->open_files = 1024;  // one for each pack
  Outcome outcome = run(command);
  const bool done = outcome.end == Outcome::End::exited && outcome.code == 0;
  if (!done) return tl::unexpected(why_failed(outcome));
  return std::move(outcome.out);
}

}  // namespace mjcourse
