// Templates: Handlebars in strict mode, where a name that the data does not have is an error.
//
// Enter with render(). Templates may include each other as partials, `{{> name}}`. They are
// compiled when first used. What comes of small data is remembered, since it often comes again: a
// thousand listings differ in their code, which has no need to come this way.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>
#include <unordered_map>

#include "script/engine.h"

namespace mjcourse {

struct TemplateError {
  std::string name;  // of the template with the mistake: a partial's own, not its user's
  std::string message;
  int line = 0;  // from 1; 0 when unknown
};

class Templates {
 public:
  // `bundle` is the text of script/templates.js; `sources` maps a template's name to its text.
  Templates(const std::string& bundle, const std::map<std::string, std::string>& sources);

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const nlohmann::json& data);

 private:
  Engine engine_;
  std::unordered_map<std::string, std::string> known_;  // HTML, by a template's name and its data
};

}  // namespace mjcourse
