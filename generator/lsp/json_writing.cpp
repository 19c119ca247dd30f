#include "lsp/json_writing.h"

#include <algorithm>

namespace mjcourse {

void JsonWriting::add_key(const std::string& name, const std::string& detail,
                          const std::string& meaning) {
  const auto& keys = place_.objects.back().keys;
  if (std::ranges::find(keys, name) != keys.end()) return;
  const std::string text = closed_ ? name : (place_.in_string ? "" : "\"") + name + "\": ";
  found_.all.push_back({name, Suggestion::Kind::property, detail, meaning, text});
}

void JsonWriting::add_text(const std::string& value, const std::string& detail) {
  const std::string text = place_.in_string ? "" : "\"" + value + "\"";
  found_.all.push_back({value, Suggestion::Kind::value, detail, "", text});
}

void JsonWriting::add_booleans(const std::string& detail) {
  if (!place_.in_string) found_.add({"true", "false"}, Suggestion::Kind::value, detail);
}

}  // namespace mjcourse
