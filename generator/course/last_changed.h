// When files of a course were changed last, as git knows it.
//
// Of all files at once, since a course may have ten thousand. A day is that of the commit's author,
// wherever it is read. A date that git cannot know is left out: one that a shallow clone cuts off,
// and that of a file with changes which are in no commit yet.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace mjcourse {

struct LastChange {
  std::string day = {};   // "2026-11-22"
  std::string time = {};  // the same moment in UTC, "2026-11-22T16:31:00Z"

  // Else it has changes that are in no commit.
  bool committed() const { return !day.empty(); }
};

// By path below a course's root.
using LastChanges = std::map<std::string, LastChange>;

struct History {
  LastChanges changes = {};
  // Why there are none though there is a repository, and what helps; "" where that has no commit.
  std::string unknown = {};
};

// Of what git knows of `folder` in `root`.
History last_changed(const std::filesystem::path& root, const std::string& folder);

}  // namespace mjcourse
