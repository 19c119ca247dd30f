// The fences whose bodies are JSON, each with its vocabulary.
// Tested by tests/generator/lesson/json/vocabulary_test.cpp.
#pragma once

#include <span>
#include <string_view>

#include "lesson/json/vocabulary.h"

namespace mjcourse {

// A fence whose body is such an object.
struct JsonFence {
  std::string_view name;    // "lab"
  std::string_view opened;  // as it is written: "lab simlab"
  const Vocabulary* vocabulary;
};

std::span<const JsonFence> json_fences();

// Of the fence of that name; null where it holds no JSON.
const Vocabulary* vocabulary_of(std::string_view fence);

}  // namespace mjcourse
