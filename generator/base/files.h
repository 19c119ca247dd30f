// Files: what the generator reads a course from.
//
// Readers take this interface and never the disk itself, so that tests read courses from memory.
// Paths are relative to the course's folder and use '/'. Every error names its path.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/beneath.h"

namespace mjcourse {

class Files {
 public:
  virtual ~Files() = default;

  // The file's bytes, or why they cannot be had ("models/x.xml: No such file or directory").
  virtual tl::expected<std::string, std::string> read(const std::string& path) const = 0;
  // Is there something under this name that is not a folder? It may be what read() refuses.
  virtual bool exists(const std::string& path) const = 0;
  // The names (not paths) of what is in `folder` and is not a folder, sorted; empty when there is
  // no such folder.
  virtual std::vector<std::string> list(const std::string& folder) const = 0;
  // The names of the folders in `folder`, sorted. Not all tell.
  virtual std::vector<std::string> folders(const std::string& /*folder*/) const { return {}; }
  // The same of what is in `folder` or in a folder below it, sorted: "scene.xml", "arm/arm.xml".
  virtual std::vector<std::string> list_below(const std::string& folder) const = 0;
  // Why the file or the folder `path`, which is there, is never read; nothing where it is not
  // there, or is read.
  virtual std::optional<FileRefusal> refusal(const std::string& /*path*/) const {
    return std::nullopt;
  }
};

// The files under `root` on the disk, and beneath it wherever links lead (beneath.h).
class DiskFiles : public Files {
 public:
  explicit DiskFiles(std::filesystem::path root, Beneath::Way way = Beneath::Way::kernel)
      : beneath_(std::move(root), way) {}

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> folders(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;
  std::optional<FileRefusal> refusal(const std::string& path) const override;

  bool is_folder(const std::string& path) const;

  // All that is below `folder`, but in `.git`; a link to a folder is not followed, and is no
  // folder. Nor is one that is too deep to be looked into, which is refused.
  struct Entry {
    std::string path;
    bool is_folder;
  };
  std::vector<Entry> below(const std::string& folder) const;

 private:
  void add_below(const std::string& folder, std::vector<Entry>& entries) const;

  Beneath beneath_;
};

// Files that exist only here: path → bytes.
class MemoryFiles : public Files {
 public:
  explicit MemoryFiles(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  tl::expected<std::string, std::string> read(const std::string& path) const override;
  bool exists(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::vector<std::string> folders(const std::string& folder) const override;
  std::vector<std::string> list_below(const std::string& folder) const override;

 private:
  std::map<std::string, std::string> files_;
};

// A file of the course that was there is gone, or cannot be read: "models/x.xml: Permission
// denied".
class LostFile : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The bytes of a file that was looked at before. Throws LostFile.
std::string read_again(const Files& files, const std::string& path);

// The bytes of a plain file that is not of a course: of the system, of the user's cache, of our
// own. Links are followed wherever they lead.
tl::expected<std::string, std::string> read_file(const std::filesystem::path& path);

// The file at `path`, which begins with `root`, as DiskFiles of that reads it.
tl::expected<std::string, std::string> read_beneath(const std::filesystem::path& root,
                                                    const std::filesystem::path& path);

// Write `bytes` to `path` on the disk, making its folders and following links: for folders of our
// own. Elsewhere it is for OutFolder (out_folder.h). Throws std::system_error with the path.
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace mjcourse
