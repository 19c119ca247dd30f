// The verdicts of an earlier run, so that a class is judged on where its work was stopped.
//
// They lie in the folder of the results, each by the hash of all that it depends on. A file that
// was damaged there is as one that is missing, and so is a verdict that others may have brought
// about: it does not depend on its key alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "base/out_folder.h"
#include "cli/grades.h"

namespace mjcourse {

class KeptVerdicts {
 public:
  // In the folder `out`; nothing is kept where it is empty. Throws RefusedPath for a folder of
  // `course` to which a link leads.
  KeptVerdicts(const std::filesystem::path& out, const std::filesystem::path& course);

  const std::optional<OutFolder>& folder() const { return folder_; }

  // The seed of an earlier run; or `seed`, which is kept, where there is none or it `is_wanted`.
  std::string seed(const std::string& seed, bool is_wanted) const;

  // The verdict on a text, of the same exercise as `like`.
  std::optional<Grade> find(const std::string& key, const Grade& like) const;

  // Unless it may be of others.
  void keep(const std::string& key, const Grade& grade) const;

 private:
  std::optional<std::string> read(const std::string& name) const;

  std::optional<OutPlace> place_;
  std::optional<OutFolder> folder_;
};

}  // namespace mjcourse
