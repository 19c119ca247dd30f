// Writing into a folder, and nowhere else, whatever names a course gives to what is written.
//
// A course is often somebody else's, so its names and what lies in its folders are not trusted: a
// name that climbs, or a link that was put in the way, would lead a write to any file of the
// user's. Here each step of a name's way is taken from the folder above it, is no link, and leads
// no higher. A file is made anew, readable by no more than the one that lay there, into which
// nothing is written. Folders that are missing are made.
//
// Enter at open_out_place(), which finds the folder for what a user has named. Reading beneath a
// folder, where links inside of it are followed, is `beneath.h`; replacing a file of the course
// with its mode kept is `replace_file.h`.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>

#include "base/descriptor.h"

namespace mjcourse {

class OutFolder {
 public:
  // `folder` is there; links on the way to it are followed. Throws std::system_error.
  explicit OutFolder(std::filesystem::path folder);

  // The path under which it was opened: for messages, and to read what was written.
  const std::filesystem::path& path() const { return path_; }
  int descriptor() const { return folder_.get(); }

  // All of these throw std::system_error with the path where the disk fails, and RefusedPath
  // (beneath.h) where `name` could lead elsewhere: it climbs, or a link lies on its way; of
  // holds_file() also where it is a link itself. They may be called on several threads at once.

  void write(const std::string& name, std::string_view bytes) const;
  // The same of what is not in memory as a whole.
  void write(const std::string& name, const std::function<void(std::ostream&)>& writer) const;
  // Is there a file under the name, or something else that is no folder? Makes nothing.
  bool holds_file(const std::string& name) const;
  // A folder in this one; "" and "." are itself.
  OutFolder inner(const std::string& name) const;
  // Renames what lies here under `name`, a file, a folder or a link, to the same name in `other`,
  // where there is nothing of the name.
  void move(const std::string& name, const OutFolder& other) const;

 private:
  OutFolder(std::filesystem::path path, Descriptor folder)
      : path_(std::move(path)), folder_(std::move(folder)) {}

  struct Spot;  // the folder on the way to something, and the name in it
  enum class Missing { is_made, stays };
  Spot spot(const std::string& name, Missing missing = Missing::is_made) const;
  Descriptor created(const std::string& name) const;

  std::filesystem::path path_;
  Descriptor folder_;
};

// The end of a path that a user has named, where the course may be a stranger's.
struct OutPath {
  std::filesystem::path path;  // absolute and without links; it need not exist
  // The checkout that the course lies in, or else the course: links in there may be a stranger's.
  std::filesystem::path root;
  std::string inside;    // `path` as seen from there; "" where it lies elsewhere
  bool is_link = false;  // one that lies in there, at which the way ends
  std::string shown;     // in messages: as seen from the course, where it lies in that
};

// Links that lie elsewhere are the user's, and are followed; those in the checkout of `course` lead
// nowhere. The course itself is there, and elsewhere; where it is "", all links are the user's.
// Throws std::system_error where links lead in a circle.
OutPath find_out_path(const std::filesystem::path& named, const std::filesystem::path& course);

// A place to write at: a folder, and the name in it.
struct OutPlace {
  OutFolder folder;
  std::string name;

  std::filesystem::path path() const { return folder.path() / name; }
};

// The place that a user has named; the folder is made where it is missing. Throws as OutFolder
// does.
OutPlace open_out_place(const std::filesystem::path& named, const std::filesystem::path& course);

}  // namespace mjcourse
