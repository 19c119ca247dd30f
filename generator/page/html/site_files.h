// SiteFiles: where the files of a site go, be it a folder or memory.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

#include "base/blob.h"

namespace mjcourse {

// `path` is relative to the site's root. All may be called on several threads at once.
class SiteFiles {
 public:
  virtual ~SiteFiles() = default;

  virtual void write(const std::string& path, std::string_view bytes) = 0;
  // The same of what is not in memory as a whole.
  virtual void write(const std::string& path, const std::function<void(std::ostream&)>& writer) = 0;
  virtual void write(const std::string& path, const Blob& bytes) { write(path, bytes.bytes()); }
  // What is copied to one path a second time is the same file.
  virtual void copy(const std::filesystem::path& from, const std::string& path) = 0;
};

}  // namespace mjcourse
