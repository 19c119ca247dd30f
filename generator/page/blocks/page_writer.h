// PageWriter: a lesson and its results as HTML.
//
// Enter at body(). Prose is written by cmark; each block of the lesson language by the template of
// its name in site/press/templates, which this class feeds with data: no HTML of a block is made
// here.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "page/blocks/lesson_context.h"
#include "script/templates.h"

namespace mjcourse {

class PageWriter {
 public:
  PageWriter(const Course& course, const Lesson& lesson, const LessonResults& results,
             PageContext context);

  std::string body();
  // The headings as a two-level list; complete once body() was written.
  const nlohmann::json& contents() const { return context_.contents; }
  // What is told at its end on paper, as answers.hbs wants it: the answers of its knowledge checks
  // and its solutions; complete once body() was written.
  const nlohmann::json& answers() const { return context_.answers; }
  // All that its knowledge checks ask, each as question.hbs wants it.
  nlohmann::json questions();
  // Its exercises, as exercises_data() has them.
  nlohmann::json exercises() const;
  // The lab that is block `index`, as lab.hbs wants it.
  nlohmann::json lab(std::size_t index);
  // What its labs need beside the page; complete once body() or all their lab() were written.
  const std::vector<LabFiles>& lab_files() const { return context_.lab_files; }

  std::string html(const Document& document) const { return context_.html(document); }
  std::string inline_html(const Document& document) const { return context_.inline_html(document); }
  // What stands inside of `node`.
  std::string children_html(cmark_node* node) const;
  const LessonContext& context() const { return context_; }

 private:
  bool takes(cmark_node* node) const;
  std::string write(cmark_node* node, const std::string& inner);
  // Of a text node: how many of its bytes stay on the line of the formula or value before it.
  std::size_t kept_before(cmark_node* text) const;
  std::string write_heading(cmark_node* node, const std::string& inner);
  void tell_later(const nlohmann::json& quiz);
  void tell_later(const Callout& callout, const nlohmann::json& data);
  std::string write_link(cmark_node* node, const std::string& inner) const;
  std::string write_math(cmark_node* node, const Math& math, std::size_t index) const;
  std::string quotation(const InlineValue& value) const;
  std::string write_value(const InlineValue& value, std::size_t index) const;
  std::string write_term(const TermUse& term, const std::string& inner) const;
  // `i` is the block's index.
  std::string write_block(cmark_node* node, std::size_t i, const std::string& inner);
  std::string write_listing(nlohmann::json data);  // as example.hbs wants it
  std::string render(const std::string& name, const nlohmann::json& data);

  LessonContext context_;
};

// Makes who renders templates, by their names and texts.
using RendererOf =
    std::function<std::unique_ptr<TemplateRenderer>(std::map<std::string, std::string>)>;

// The templates that the site's build left in `assets`, with their engine, unless `renderer_of`
// makes another one.
Templates site_templates(const Files& assets, std::size_t memory = kLittleMemory,
                         const RendererOf& renderer_of = {});

// Why a template could not be rendered, with its name and line.
class BrokenTemplate : public std::runtime_error {
 public:
  explicit BrokenTemplate(TemplateError error);
  const TemplateError& error() const { return error_; }

 private:
  TemplateError error_;
};

// Render a template that must render: the data is ours. Throws BrokenTemplate where it does not.
std::string render_template(Templates& templates, const std::string& name,
                            const nlohmann::json& data);
// Puts `text` in the place of the placeholder `part` of `html`, which the template `name` has made
// with it as `key`. Throws BrokenTemplate where that left it out, or has it twice.
void fill_in(std::string& html, const std::string& name, const std::string& key,
             std::string_view part, std::string_view text);

}  // namespace mjcourse
