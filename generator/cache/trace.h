// Trace: what one piece of work has looked at, written down as it looks.
//
// An evaluator of a block reads files through `files()` and names whatever else it uses. So a
// result's dependencies are those that it had, and not those that somebody thought it had.
// Tested by tests/generator/cache/result_store_test.cpp.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"
#include "base/origin.h"
#include "cache/dependency.h"

namespace mjcourse {

class Trace {
 public:
  // `root` is the course's folder.
  explicit Trace(const std::filesystem::path& root);

  const std::filesystem::path& root() const { return root_; }

  void clear();

  // A file or a folder, there or not; relative to the course, or absolute. False when it was named
  // before.
  bool file(const std::filesystem::path& path);
  // Files that many a piece of work has looked at (dependency_sets.h). Those of the course are
  // written down one by one.
  void files(const std::vector<std::string>& paths);
  // Which folders are below `folder`, and which files there are called as one of `paths`: each may
  // be found in place of that one.
  void headers_in(const std::filesystem::path& folder, const std::vector<std::string>& paths);
  // What the program `name` reported.
  void program(const std::string& name);
  // What somebody else has looked at for the same piece of work, as its trace names it.
  void add(const std::set<std::string>& names) { names_.insert(names.begin(), names.end()); }
  void add(const Trace& other);
  // What a result depends on that was found in place of work, and where that one is from.
  void found(const Dependencies& traced, const Origin& origin);
  // Something that cannot be named: the result must not be used again.
  void unknown() { complete_ = false; }

  bool complete() const { return complete_; }
  const std::set<std::string>& names() const { return names_; }
  // Each a list of absolute paths.
  const std::set<std::vector<std::string>>& sets() const { return sets_; }
  // What files are called, by the folders in which they were looked for.
  using Headers = std::map<std::string, std::set<std::string>>;
  const Headers& headers() const { return headers_; }
  // What was found, by the names of dependencies: what was behind them then.
  const Dependencies& found() const { return found_; }
  // Of all of it together.
  const Origin& origin() const { return origin_; }

 private:
  std::filesystem::path root_;
  std::set<std::string> names_;
  std::set<std::vector<std::string>> sets_;
  Headers headers_;
  Dependencies found_;
  Origin origin_;
  bool complete_ = true;
};

// The files of the course, each written down in a trace.
class TracedFiles : public Files {
 public:
  TracedFiles(const std::filesystem::path& root, Trace& trace) : files_(root), trace_(trace) {}

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;
  std::optional<FileRefusal> refusal(const std::string& path) const override;

 private:
  DiskFiles files_;
  Trace& trace_;
};

}  // namespace mjcourse
