// SiteDirectory: a site that is replaced as a whole or not at all.
//
// Files are written into a folder beside the site; commit() puts that folder in the site's place
// with one rename, so a kill at any moment leaves either the old site or the new one. Then what is
// foreign in the old one (foreign_files.h) is renamed into the new one; where that fails, all is
// put back as it was. What a killed build left behind is removed by the next, which also moves what
// is foreign in it. Whatever the names of a course say, all of it is written beneath these two
// folders (base/out_folder.h).
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "base/descriptor.h"
#include "base/out_folder.h"
#include "page/html/site_files.h"

namespace mjcourse {

class SiteDirectory : public SiteFiles {
 public:
  // Throws FolderRefused where `site` holds something that no build made.
  static void refuse_others(const std::filesystem::path& site);

  // The folder is found as by open_out_place(), and throws as that and refuse_others() do;
  // std::runtime_error when another build is at work on it. What is copied is read beneath
  // `course`.
  explicit SiteDirectory(const std::filesystem::path& site, std::filesystem::path course = {});
  ~SiteDirectory() override;
  SiteDirectory(const SiteDirectory&) = delete;
  SiteDirectory& operator=(const SiteDirectory&) = delete;

  using SiteFiles::write;
  void write(const std::string& path, std::string_view bytes) override;
  void write(const std::string& path, const std::function<void(std::ostream&)>& writer) override;
  void copy(const std::filesystem::path& from, const std::string& path) override;
  // A file or a folder of our own.
  void copy_own(const std::filesystem::path& from, const std::string& path);

  // Where it is until commit().
  const OutFolder& folder() const { return *staging_; }
  // Throws FolderRefused where something foreign is in the way of the new site.
  void commit();

 private:
  bool is_new(const std::string& path);
  void put_back_foreign_files();
  void put_into_place(unsigned flags);

  const OutPlace place_;
  const std::filesystem::path site_, course_;
  const std::string making_;  // what the folder beside it is called until then
  Descriptor lock_;
  std::optional<OutFolder> staging_;  // there from the constructor on
  bool holds_foreign_files_ = false;  // in the staging folder
  std::mutex mutex_;
  std::set<std::string> copied_;  // paths
};

}  // namespace mjcourse
