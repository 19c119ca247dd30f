// Fingerprints: what the things that results depend on are now.
//
// A file's is the SHA-256 of its bytes, taken once and believed for as long as the file's status
// stays the same; a folder's is that of the names in it.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "cache/fingerprint_cache.h"

namespace mjcourse {

class Fingerprints {
 public:
  // `root` is the course's folder. What is found out of files goes to `files`.
  explicit Fingerprints(
      const std::filesystem::path& root,
      std::shared_ptr<FingerprintCache> files = std::make_shared<FingerprintCache>());

  // Of a dependency's name. From any thread.
  std::string of(const std::string& name);

  // The folders below `folder` and the files there that have one of these names, in their order;
  // paths below it, "" where there is none. What is there is looked at anew each time.
  std::string headers_in(const std::string& folder, const std::set<std::string>& names) const;

  // What a program reported, once that is known.
  void set(const std::string& name, const std::string& value);

  // Has this stayed as it is since `begin`? When in doubt, it has not: a result that was made while
  // somebody saved a file belongs to neither version.
  bool unchanged_since(const std::string& name, std::chrono::system_clock::time_point begin) const;
  // And what there is in this folder and in all below it?
  bool tree_unchanged_since(const std::string& folder,
                            std::chrono::system_clock::time_point begin) const;

 private:
  std::filesystem::path root_;
  std::shared_ptr<FingerprintCache> files_;
  mutable std::mutex mutex_;
  std::map<std::string, std::string> others_;
};

}  // namespace mjcourse
