// git, of a repository that somebody else may have made.
//
// What lies in a repository can have git start programs: its settings name hooks, filters, pagers
// and tools for differences, and a folder of a course may look like a repository of its own. So we
// find the repository, git is told which it is, reads that and nothing else, and starts nothing.
// Nor does what a user has set up for git change what it prints.
//
// git itself refuses a repository of another owner ("dubious ownership"), which every container
// has, since its configuration could make git start that owner's programs. Here it cannot, so a
// repository of any owner is read, without an entry in `safe.directory`.
// Tested by tests/generator/course/last_changed_test.cpp.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace mjcourse {

class Git {
 public:
  // The repository that `folder` lies in; nothing where it lies in none.
  static std::optional<Git> find(const std::filesystem::path& folder);

  // What git prints, run in the folder, or why it does not, on one line.
  tl::expected<std::string, std::string> ask(const std::vector<std::string>& arguments) const;

 private:
  std::filesystem::path folder_, work_tree_;
  // Its own folder, and all that it keeps elsewhere.
  std::filesystem::path own_;
  std::vector<std::string> read_;
  // Why it is not asked, where it would be held up; "" for nothing.
  std::string trouble_;
};

}  // namespace mjcourse
