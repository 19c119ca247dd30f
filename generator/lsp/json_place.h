// JsonPlace: where in a JSON text an author is after so much of it: in which objects, behind which
// key, in a string or between two. The text need not go on, and need not be right.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mjcourse {

struct JsonPlace {
  struct Object {
    int lists = 0;                             // that it stands in, within the object around it
    std::map<std::string, std::string> texts;  // its strings so far, by their keys
    // Those of the objects that it has, by their own keys; not of what these have in turn.
    std::map<std::string, std::map<std::string, std::string>> within;
    std::vector<std::string> keys;  // all of its keys so far
    std::string key;                // behind which the place is; "" before it
  };
  std::vector<Object> objects;  // from the outside in
  int lists = 0;                // that the place stands in, within the innermost object
  bool in_string = false;
  std::string part;  // of the string that the place is in, so far and without escapes

  // A key is being written, or would be.
  bool at_key() const { return !objects.empty() && lists == 0 && objects.back().key.empty(); }
  // The string behind `key` in the innermost object that has one; "" where none has.
  std::string text(const std::string& key) const;
  // The same of `key` in the object behind `object`.
  std::string text_within(const std::string& object, const std::string& key) const;
};

// `before`: the text up to the place. Deeper than a lesson is read it is in no object.
JsonPlace json_place(std::string_view before);

}  // namespace mjcourse
