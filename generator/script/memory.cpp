#include "script/memory.h"

namespace mjcourse {

const std::string* Memory::find(const std::string& question) const {
  const auto known = known_.find(question);
  return known == known_.end() ? nullptr : &known->second;
}

void Memory::keep(const std::string& question, const std::string& answer) {
  const std::size_t bytes = question.size() + answer.size();
  if (bytes > most_ / 100) return;
  if (bytes_ + bytes > most_) {
    known_.clear();
    bytes_ = 0;
  }
  if (known_.try_emplace(question, answer).second) bytes_ += bytes;
}

}  // namespace mjcourse
