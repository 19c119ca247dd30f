// Templates: Handlebars in strict mode, where a name that the data does not have is an error.
//
// A course's theme may be a stranger's. So a template ends after the engine's time, and is of a
// bounded size, as is what it makes; and where a course has templates of its own, they are rendered
// in another process (page/template_process.h).
//
// Enter with render(). Templates may include each other as partials, `{{> name}}`. They are
// compiled when first used. What came of some data is remembered, as far as there is memory for it:
// small data often comes again.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <tl/expected.hpp>

#include "script/engine.h"
#include "script/memory.h"

namespace mjcourse {

struct TemplateError {
  // Of the template with the mistake: a partial's own, not its user's. "" of all of a theme's
  // together.
  std::string name;
  std::string message;
  int line = 0;        // from 1; 0 when unknown
  std::string cure{};  // where the message does not say it
};

// Who renders.
class TemplateRenderer {
 public:
  virtual ~TemplateRenderer() = default;
  // `data` is JSON.
  virtual tl::expected<std::string, TemplateError> render(const std::string& name,
                                                          const std::string& data) = 0;
};

// In this process. `bundle` is the text of script/templates.js; `sources` maps a template's name to
// its text.
class TemplateEngine : public TemplateRenderer {
 public:
  TemplateEngine(const std::string& bundle, const std::map<std::string, std::string>& sources);

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const std::string& data) override;

 private:
  Engine engine_;
};

class Templates {
 public:
  // `memory` is in bytes.
  explicit Templates(std::unique_ptr<TemplateRenderer> renderer,
                     std::size_t memory = kLittleMemory);
  // Of a TemplateEngine.
  Templates(const std::string& bundle, const std::map<std::string, std::string>& sources,
            std::size_t memory = kLittleMemory);

  tl::expected<std::string, TemplateError> render(const std::string& name,
                                                  const nlohmann::json& data);

 private:
  std::unique_ptr<TemplateRenderer> renderer_;
  Memory known_;  // HTML, by a template's name and its data
};

}  // namespace mjcourse
