// What lies in a site's folder and was written by no build: a user's `.git`, `CNAME`, own pages.
//
// A site knows what it wrote: `.mjcourse-site` at its root lists its files. All else is the user's,
// and goes along when a new site takes the old one's place.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/out_folder.h"

namespace mjcourse {

inline constexpr const char* kSiteList = ".mjcourse-site";

// A folder of the user's is in the way; what() says which.
class FolderRefused : public std::runtime_error {
 public:
  FolderRefused(const std::string& message, std::string cure)
      : std::runtime_error(message), cure_(std::move(cure)) {}
  const std::string& cure() const { return cure_; }

 private:
  std::string cure_;
};

// Lists all that is in `site` now as written by this build.
void write_site_list(const OutFolder& site);
bool has_site_list(const std::filesystem::path& site);

// The paths of what `site` does not list, each to be moved into `other`: a whole folder where
// `other` has none of that name. Throws FolderRefused where `other` has something in its place.
std::vector<std::string> foreign_files(const std::filesystem::path& site,
                                       const std::filesystem::path& other);

// The paths of what `site` does not list.
std::vector<std::string> foreign_files(const std::filesystem::path& site);

// Throws FolderRefused where something of these could not be moved, and std::system_error where it
// cannot be known: what a command asks before its work. Nothing where `site` has no list.
void refuse_unmovable_files(const std::filesystem::path& site);

// Moves these by renaming them. All are where they were when this throws FolderRefused or
// std::system_error.
void move_foreign_files(const OutFolder& site, const OutFolder& other);

}  // namespace mjcourse
