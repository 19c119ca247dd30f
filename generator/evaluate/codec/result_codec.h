// Results as bytes, for a store, and back.
//
// CBOR, which keeps every bit of a number. Pictures and films are not in it: the store has them
// under their hashes, which are. A course's files are named below its folder, so another machine
// can use the result.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/store.h"
#include "findings/finding.h"

namespace mjcourse {

class ResultCodec {
 public:
  // `root` is the course's folder; both must outlive what is decoded.
  ResultCodec(Store& store, std::filesystem::path root) : store_(store), root_(std::move(root)) {}

  // Puts the finding's pictures into the store; nothing where it does not take them. The blocks are
  // counted from `first`, so that they may have moved when they are decoded.
  std::optional<std::string> encode(Finding& finding, std::size_t first) const;
  // Nothing where the store has lost a part of it.
  std::optional<Finding> decode(const std::string& bytes, std::size_t first) const;

 private:
  bool keep_blobs(Finding& finding) const;

  Store& store_;
  std::filesystem::path root_;
};

// A hash of what a program reported.
std::string fingerprint_of(const Records& records);

}  // namespace mjcourse
