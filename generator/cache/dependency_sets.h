// DependencySets: makes one dependency of many files that results depend on alike.
//
// Behind each program stand the same hundreds of headers. As a dependency they have one name,
// `files HASH`, and one value. Both are addresses in the store: of the list of their names, and of
// that list with what is behind each. So to look whether a result may be used again takes one
// comparison, and only a caller that wants to know which of the files has changed finds it out.
//
// A file that is added later can come in place of one of these only if it has that one's name. So
// of an include folder the names of such files are one dependency, `headers in FOLDER HASH`, and
// any other file may be added.
// Tested by tests/generator/cache/result_store_test.cpp.
#pragma once

#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "base/store.h"
#include "cache/dependency.h"
#include "cache/fingerprints.h"

namespace mjcourse {

class DependencySets {
 public:
  // Both must outlive this.
  DependencySets(Store& store, Fingerprints& fingerprints)
      : store_(store), fingerprints_(fingerprints) {}

  static bool is_name(const std::string& dependency);

  // All from any thread.
  std::string name_of(const std::vector<std::string>& files);
  std::string name_of(const std::string& folder, const std::set<std::string>& headers);
  // What is behind a name; `now`, or when that was last looked at here. Where the
  // store has lost their names, they are absent.
  std::string now(const std::string& name);
  std::string known(const std::string& name);

  // With each file of a set as a dependency of its own, as far as the store has it.
  Dependencies one_by_one(const Dependencies& dependencies);

 private:
  std::string keep(const std::string& list);
  std::string found_now(const std::string& name);

  Store& store_;
  Fingerprints& fingerprints_;
  std::mutex reading_, mutex_;
  std::map<std::string, std::string> known_;  // by names
};

}  // namespace mjcourse
