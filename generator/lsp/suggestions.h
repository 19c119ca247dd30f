// Suggestions: what could be written at a place.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mjcourse {

struct Suggestion {
  // As the protocol numbers them.
  enum class Kind { field = 5, property = 10, value = 12, keyword = 14, file = 17, reference = 18 };

  std::string name;
  Kind kind = Kind::value;
  std::string detail = {};   // one line
  std::string meaning = {};  // our own Markdown, without a word of the course
  std::string text = {};     // what is written; empty for the name
};

struct Suggestions {
  std::size_t begin = 0;  // the first byte of what they replace, up to the place
  std::vector<Suggestion> all = {};

  void add(const std::vector<std::string>& names, Suggestion::Kind kind,
           const std::string& detail) {
    for (const std::string& name : names) all.push_back({name, kind, detail});
  }
};

}  // namespace mjcourse
