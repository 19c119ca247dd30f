// MemorySite: the files of a site that is in no folder.
#pragma once

#include <map>
#include <mutex>
#include <optional>

#include "page/html/site_files.h"

namespace mjcourse {

class MemorySite : public SiteFiles {
 public:
  void write(const std::string& path, std::string_view bytes) override;
  void write(const std::string& path, const std::function<void(std::ostream&)>& writer) override;
  void write(const std::string& path, const Blob& bytes) override;
  // Only remembered: it is read when it is asked for.
  void copy(const std::filesystem::path& from, const std::string& path) override;

  // Nothing where there is no such file, or where what was copied is gone or leads out of
  // `allowed`.
  std::optional<std::string> read(const std::string& path,
                                  const std::filesystem::path& allowed) const;

  // The hashes of what a page shows under an address that stays the same.
  std::map<std::string, std::string> hashes() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, Blob> blobs_;
  std::map<std::string, std::filesystem::path> copies_;
};

}  // namespace mjcourse
