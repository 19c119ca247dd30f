// ClaimSources: the bytes that claims were computed from, each as a hash, for their keys.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cache/fingerprints.h"
#include "toolchain/include_folders.h"

namespace mjcourse {

class ClaimSources {
 public:
  // `root` is the course's folder, `models` the names of its models, `include` where its programs
  // find headers. `fingerprints`, those of the course, must outlive this.
  ClaimSources(const std::filesystem::path& root, std::vector<std::string> models,
               IncludeFolders include, Fingerprints& fingerprints)
      : root_(std::filesystem::absolute(root).lexically_normal()),
        models_(std::move(models)),
        include_(std::move(include)),
        fingerprints_(fingerprints) {}

  // All from any thread.
  // Of a model of the course: its file, and all files that this names. Empty when there is none.
  std::string model(const std::string& name);
  // Of all models that a program's or a question's text names: "joint_zoo" or joint_zoo.xml.
  std::string models_named_in(const std::string& text);
  // Of these files, relative to the course.
  std::string files(const std::vector<std::string>& paths);
  // Of the course's own headers and the helper header.
  std::string helper();

 private:
  std::string of(const std::filesystem::path& file);
  std::string read_model(const std::string& name);
  std::string read_helper();

  std::filesystem::path root_;
  std::vector<std::string> models_;
  IncludeFolders include_;
  Fingerprints& fingerprints_;
  std::mutex mutex_;
  std::map<std::string, std::string> known_;  // of models, by name
  std::optional<std::string> helper_;
};

// The hash of all of these, in this order.
std::string hash_of(const std::vector<std::string>& parts);

}  // namespace mjcourse
