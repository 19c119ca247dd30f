// A model's text with everything that it includes in its place, and where each element came from.
//
// MuJoCo puts a model together before it reads it, and forgets the lines of what was included. Here
// each element has a line of its own, so a line that MuJoCo names leads back to a file.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mjcourse {

struct WholeMjcf {
  struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string file;
    int line;
    std::string parent = {};  // the name of the element around it
  };
  std::string text;               // line 1 is the first element
  std::vector<Element> elements;  // as they stand in `text`
  bool includes = false;
};

// Of the MJCF `text` of `file`, beside which MuJoCo looks for what it includes. `read` gives a
// file's content, "" for none. What is not well-formed is left out, as what includes itself is.
WholeMjcf whole_mjcf(const std::string& file, const std::string& text,
                     const std::function<std::string(const std::string& path)>& read);

}  // namespace mjcourse
