// PageWriter: a lesson and its results as HTML.
//
// Enter at body(). Prose is written by cmark; each block of the lesson language by the template of
// its name in site/press/templates, which this class feeds with data: no HTML of a block is made
// here.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/course.h"
#include "findings/lesson_results.h"
#include "findings/result.h"
#include "page/blocks/lab_module.h"
#include "page/html/inline_styles.h"
#include "page/html/markdown_html.h"
#include "script/highlight.h"
#include "script/templates.h"

namespace mjcourse {

// The tools that all pages share.
struct PageContext {
  Templates& templates;
  Highlighter& highlighter;
  const nlohmann::json& manifest;  // the way from a plain name of an asset to its path
  InlineStyles& styles;            // of the page being written
  // The page being written, below the site's root; "" for the lesson's own.
  std::string page = {};
  // What each term of the glossary means, by its key (page/glossary_page.h).
  const std::map<std::string, std::string>* definitions = nullptr;
  bool places = false;  // a lesson's text has its lines in comments (page/html/place_marks.h)
};

class PageWriter {
 public:
  PageWriter(const Course& course, const Lesson& lesson, const LessonResults& results,
             PageContext context);

  std::string body();
  // The headings as a two-level list; complete once body() was written.
  nlohmann::json contents() const { return contents_; }
  // What is told at its end on paper, as answers.hbs wants it: the answers of its knowledge checks
  // and its solutions; complete once body() was written.
  nlohmann::json answers() const { return answers_; }
  // All that its knowledge checks ask, each as question.hbs wants it.
  nlohmann::json questions();
  // The lab that is block `index`, as lab.hbs wants it.
  nlohmann::json lab(std::size_t index);
  // What its labs need beside the page; complete once body() or all their lab() were written.
  const std::vector<LabFiles>& lab_files() const { return lab_files_; }

  std::string html(const Document& document) const { return render_html(document.get(), writer_); }
  std::string inline_html(const Document& document) const {
    return render_inline_html(document.get(), writer_);
  }
  // What stands inside of `node`.
  std::string children_html(cmark_node* node) const;
  // For a script to put into the page: the stylesheet of the page has what it needs.
  std::string scripted_html(const Document& document) const {
    return context_.styles.take(html(document));
  }

 private:
  bool takes(cmark_node* node) const;
  std::string write(cmark_node* node, const std::string& inner);
  // Of a text node: how many of its bytes stay on the line of the formula or value before it.
  std::size_t kept_before(cmark_node* text) const;
  std::string write_heading(cmark_node* node, const std::string& inner);
  void tell_later(const nlohmann::json& quiz);
  void tell_later(const Callout& callout, const nlohmann::json& data);
  void list_heading(int level, const std::string& id, const std::string& title);
  std::string write_link(cmark_node* node, const std::string& inner) const;
  std::string write_math(cmark_node* node, const Math& math, std::size_t index) const;
  std::string write_value(const InlineValue& value, std::size_t index) const;
  std::string write_term(const TermUse& term, const std::string& inner) const;
  std::string from_root(const std::string& path) const;
  // `i` is the block's index.
  std::string write_block(cmark_node* node, std::size_t i, const std::string& inner);
  std::string write_listing(nlohmann::json data);  // as example.hbs wants it

  nlohmann::json data_of(const Example& example, std::size_t index);
  nlohmann::json data_of(const Unchecked& unchecked);
  nlohmann::json data_of(const Snippet& snippet, std::size_t index);
  nlohmann::json data_of(const Commands& commands, std::size_t index);
  nlohmann::json data_of(const ModelExcerpt& excerpt);
  nlohmann::json data_of(const InlineModel& model, std::size_t index);
  nlohmann::json listing(const std::string& code, const std::string& language);
  nlohmann::json data_of(const Output& output, std::size_t index);
  // Those of a program's stated outputs that do not stand somewhere else in the lesson.
  std::vector<std::size_t> outputs_below(const std::vector<std::size_t>& outputs) const;
  bool are_proved(const std::vector<std::size_t>& outputs) const;
  // `wanted`, with a number behind it where the page has it already.
  std::string unique_id(const std::string& wanted);
  nlohmann::json data_of(const Lab& lab, std::size_t index);
  nlohmann::json asked_data(const Lab& lab) const;
  nlohmann::json live_data(const Lab& lab, const LabResult& result, std::size_t index);
  nlohmann::json data_of(const Figure& figure, std::size_t index);
  nlohmann::json data_of(const Plot& plot, std::size_t index);
  nlohmann::json data_of(const Quiz& quiz, std::size_t index);
  nlohmann::json data_of(const Question& question, const QuestionResult& result,
                         const std::string& id, std::size_t number);
  std::string report_on(std::size_t block, std::size_t part) const;
  void add_options(const Question& question, nlohmann::json& data);
  void add_items(const Question& question, nlohmann::json& data);
  nlohmann::json data_of(const Image& image, const ImageResult& result) const;
  nlohmann::json data_of(const Io& io) const;
  nlohmann::json data_of(const Callout& callout, const std::string& inner) const;
  nlohmann::json data_of(const Demo& demo);
  std::string render(const std::string& name, const nlohmann::json& data);

  const Course& course_;
  const Lesson& lesson_;
  const LessonResults& results_;
  PageContext context_;
  NodeWriter writer_;
  nlohmann::json contents_ = nlohmann::json::array();
  nlohmann::json answers_ = nlohmann::json::array();
  std::vector<LabFiles> lab_files_;
  std::set<std::string> ids_;  // of listings
};

// The templates that the site's build left in `assets`, with their engine.
Templates site_templates(const Files& assets, std::size_t memory = kLittleMemory);

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
