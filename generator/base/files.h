// Files: what the generator reads a course from.
//
// Readers take this interface and never the disk itself, so that tests read courses from memory.
// Paths are relative to the course's folder and use '/'. Every error names its path.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace mjcourse {

class Files {
 public:
  virtual ~Files() = default;

  // The file's bytes, or why they cannot be had ("models/x.xml: No such file or directory").
  virtual tl::expected<std::string, std::string> read(const std::string& path) const = 0;
  virtual bool exists(const std::string& path) const = 0;
  // The names (not paths) of the regular files in `folder`, sorted; empty when there is no such
  // folder.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
};

// The files under `root` on the disk.
class DiskFiles : public Files {
 public:
  explicit DiskFiles(std::filesystem::path root) : root_(std::move(root)) {}

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;

 private:
  std::filesystem::path root_;
};

// Files that exist only here: path → bytes.
class MemoryFiles : public Files {
 public:
  explicit MemoryFiles(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;

 private:
  std::map<std::string, std::string> files_;
};

// Write `bytes` to `path` on the disk, making its folders. Throws std::system_error with the path.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace mjcourse
