// Templates: Handlebars in strict mode, where a name that the data does not have is an error.
//
// A course's theme may be a stranger's. So a template ends after the engine's time, and is of a
// bounded size, as is what it makes.
//
// Enter with render(). Templates may include each other as partials, `{{> name}}`. They are
// compiled when first used. What came of some data is remembered, as far as there is memory for it:
// small data often comes again.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "script/engine.h"
#include "script/memory.h"

namespace mjcourse {

struct TemplateError {
  std::string name;  // of the template with the mistake: a partial's own, not its user's
  std::string message;
  int line = 0;        // from 1; 0 when unknown
  std::string cure{};  // where the message does not say it
};

class Templates {
 public:
  // `bundle` is the text of script/templates.js; `sources` maps a template's name to its text.
  // `memory` is in bytes.
  Templates(const std::string& bundle, const std::map<std::string, std::string>& sources,
            std::size_t memory = kLittleMemory);

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const nlohmann::json& data);

 private:
  Engine engine_;
  Memory known_;  // HTML, by a template's name and its data
};

}  // namespace mjcourse
