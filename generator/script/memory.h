// Memory: what a script answered, so that the same question is asked only once.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>

namespace mjcourse {

// Of a site that is written once: only what is small comes often.
inline constexpr std::size_t kLittleMemory = 100'000;

class Memory {
 public:
  // Of at most so many bytes. What alone would take more than a hundredth of them is not kept.
  explicit Memory(std::size_t bytes) : most_(bytes) {}

  // Null where it is not known. It is good until something else is kept.
  const std::string* find(const std::string& question) const;
  void keep(const std::string& question, const std::string& answer);

 private:
  std::size_t most_, bytes_ = 0;
  std::unordered_map<std::string, std::string> known_;
};

}  // namespace mjcourse
