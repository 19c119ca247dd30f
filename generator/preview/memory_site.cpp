#include "preview/memory_site.h"

#include <sstream>
#include <utility>

#include "base/files.h"
#include "preview/inside.h"

namespace mjcourse {

void MemorySite::write(const std::string& path, std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  texts_[path] = bytes;
}

void MemorySite::write(const std::string& path, const std::function<void(std::ostream&)>& writer) {
  std::ostringstream text;
  writer(text);
  write(path, std::move(text).str());
}

void MemorySite::write(const std::string& path, const Blob& bytes) {
  const std::lock_guard lock(mutex_);
  blobs_[path] = bytes;
}

void MemorySite::copy(const std::filesystem::path& from, const std::string& path) {
  const std::lock_guard lock(mutex_);
  copies_[path] = from;
}

std::optional<std::string> MemorySite::read(const std::string& path,
                                            const std::filesystem::path& allowed) const {
  const std::lock_guard lock(mutex_);
  if (const auto text = texts_.find(path); text != texts_.end()) return text->second;
  if (const auto blob = blobs_.find(path); blob != blobs_.end()) return blob->second.bytes();
  const auto copy = copies_.find(path);
  return copy == copies_.end() ? std::nullopt : read_inside(allowed, copy->second);
}

std::map<std::string, std::string> MemorySite::hashes() const {
  const std::lock_guard lock(mutex_);
  std::map<std::string, std::string> hashes;
  for (const auto& [path, blob] : blobs_) hashes[path] = blob.hash();
  return hashes;
}

}  // namespace mjcourse
