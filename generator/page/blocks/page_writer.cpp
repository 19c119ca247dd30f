#include "page/blocks/page_writer.h"

#include <algorithm>
#include <map>
#include <utility>

#include "course/link_target.h"
#include "course/web_address.h"
#include "page/blocks/block_data.h"
#include "page/blocks/figure_data.h"
#include "page/blocks/lab_data.h"
#include "page/blocks/plot_data.h"
#include "page/blocks/quiz_data.h"
#include "page/html/formula_text.h"
#include "page/html/kept_together.h"
#include "page/html/place_marks.h"
#include "page/html/placeholder.h"
#include "page/html/site_paths.h"
#include "script/script_bundles.h"

namespace mjcourse {
namespace {

// In TeX: so many characters, as of "-179", never fill a line.
constexpr std::size_t kLongestNumber = 8;
// In characters: they fit into the line of a phone.
constexpr std::size_t kLongestWhole = 24;

// HTML has no `align` any more, which is how cmark aligns the cells of a table.
std::string aligned_by_class(std::string table) {
  const std::pair<std::string, std::string> changes[] = {{" align=\"left\"", ""},
                                                         {" align=\"center\"", " class=\"center\""},
                                                         {" align=\"right\"", " class=\"end\""}};
  for (const auto& [attribute, instead] : changes) {
    for (const std::string cell : {"<td", "<th"}) {
      for (std::size_t at = 0; (at = table.find(cell + attribute, at)) != table.npos;) {
        table.replace(at + cell.size(), attribute.size(), instead);
      }
    }
  }
  return table;
}

// The box of an item of a task list is a picture of its state, which is said in words as well.
std::string with_named_box(std::string item) {
  const std::string box = "<input type=\"checkbox\"";
  const std::size_t at = item.find(box);
  const bool done = item.compare(at + box.size(), 8, " checked") == 0;
  return item.insert(at + box.size(), done ? " aria-label=\"done\"" : " aria-label=\"to do\"");
}

// Code that a browser would break at its hyphen: `data->qpos`, `--strict`.
bool stays_whole(cmark_node* node) {
  if (cmark_node_get_type(node) != CMARK_NODE_CODE) return false;
  const std::string_view code = cmark_node_get_literal(node);
  return code.size() <= kLongestWhole && code.find('-') != code.npos;
}

// A function for each kind of block, for std::visit.
// To compile one takes thousands of times its size.
constexpr std::size_t kMostOfATemplate = 256 << 10;  // bytes

template <typename... Functions>
struct Cases : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Cases(Functions...) -> Cases<Functions...>;

}  // namespace

Templates site_templates(const Files& assets, std::size_t memory, const RendererOf& renderer_of) {
  std::map<std::string, std::string> sources;
  for (const std::string& name : assets.list("templates")) {
    if (!name.ends_with(".hbs")) continue;
    const std::string own = name.substr(0, name.size() - 4);
    auto source = assets.read("templates/" + name);
    if (!source) throw BrokenTemplate(TemplateError{own, source.error()});
    if (source->size() > kMostOfATemplate) {
      throw BrokenTemplate(TemplateError{
          own, "is larger than " + std::to_string(kMostOfATemplate >> 10) + " KiB", 0,
          "put parts of it into templates of their own, and what is no template into a file"});
    }
    sources[own] = *std::move(source);
  }
  if (renderer_of) return Templates(renderer_of(std::move(sources)), memory);
  return {script_bundle(assets, "templates"), sources, memory};
}

BrokenTemplate::BrokenTemplate(TemplateError error)
    : std::runtime_error("template " + error.name + ".hbs, line " + std::to_string(error.line) +
                         ": " + error.message),
      error_(std::move(error)) {}

std::string render_template(Templates& templates, const std::string& name,
                            const nlohmann::json& data) {
  tl::expected<std::string, TemplateError> html = templates.render(name, data);
  if (html) return *std::move(html);
  throw BrokenTemplate(std::move(html.error()));
}

void fill_in(std::string& html, const std::string& name, const std::string& key,
             std::string_view part, std::string_view text) {
  if (fill_placeholder(html, part, text)) return;
  throw BrokenTemplate(TemplateError{name, "`{{{" + key + "}}}` must stand here, and once"});
}

PageWriter::PageWriter(const Course& course, const Lesson& lesson, const LessonResults& results,
                       PageContext context)
    : context_(course, lesson, results, std::move(context)) {
  context_.writer.takes = [this](cmark_node* node) { return takes(node); };
  context_.writer.write = [this](cmark_node* node, const std::string& inner) {
    return write(node, inner);
  };
}

std::string PageWriter::body() {
  if (!context_.page.places) return html(context_.lesson.document);
  const PlaceMarks marks(context_.lesson, context_.results);
  return html(context_.lesson.document) + kEndOfPlaces;
}

nlohmann::json PageWriter::questions() {
  return questions_data(context_);
}

nlohmann::json PageWriter::exercises() const {
  return exercises_data(context_);
}

nlohmann::json PageWriter::lab(std::size_t index) {
  return lab_data(std::get<Lab>(context_.lesson.blocks[index]), index, context_);
}

std::string PageWriter::render(const std::string& name, const nlohmann::json& data) {
  return render_template(context_.page.templates, name, data);
}

bool PageWriter::takes(cmark_node* node) const {
  const cmark_node_type type = cmark_node_get_type(node);
  const std::string name = cmark_node_get_type_string(node);
  return context_.lesson.block(node) != nullptr || type == CMARK_NODE_HEADING ||
         type == CMARK_NODE_LINK || name == "table" || name == "tasklist" ||
         kept_before(node) > 0 || stays_whole(node) ||
         (type == CMARK_NODE_TEXT && has_units(cmark_node_get_literal(node)));
}

std::size_t PageWriter::kept_before(cmark_node* text) const {
  if (text == nullptr || cmark_node_get_type(text) != CMARK_NODE_TEXT) return 0;
  cmark_node* before = cmark_node_previous(text);
  const Block* block = before != nullptr ? context_.lesson.block(before) : nullptr;
  if (block == nullptr) return 0;
  const auto* math = std::get_if<Math>(block);
  const bool is_number = math != nullptr ? math->tex.text.size() <= kLongestNumber
                                         : std::holds_alternative<InlineValue>(*block);
  const std::string_view literal = cmark_node_get_literal(text);
  // A value is text, behind which no browser ends a line before a comma.
  const bool keeps = literal.starts_with(' ') ? is_number : math != nullptr && !math->display;
  return keeps ? kept_length(literal) : 0;
}

std::string PageWriter::write(cmark_node* node, const std::string& inner) {
  if (const auto block = context_.lesson.block_of.find(node);
      block != context_.lesson.block_of.end()) {
    cmark_node* next = cmark_node_next(node);
    if (kept_before(next) == 0) return write_block(node, block->second, inner);
    const bool unit = cmark_node_get_literal(next)[0] == ' ';
    return std::string("<span class=\"with-") + (unit ? "unit" : "mark") + "\">" +
           write_block(node, block->second, inner);
  }
  const cmark_node_type type = cmark_node_get_type(node);
  if (type == CMARK_NODE_TEXT) {
    const std::string_view text = cmark_node_get_literal(node);
    const std::size_t kept = kept_before(node);
    const std::string rest = escape_html(with_kept_units(text.substr(kept)));
    return kept == 0 ? rest : escape_html(text.substr(0, kept)) + "</span>" + rest;
  }
  if (type == CMARK_NODE_CODE) {
    const std::string_view code = cmark_node_get_literal(node);
    return "<code class=\"whole\">" + escape_html(code) + "</code>";
  }
  if (type == CMARK_NODE_HEADING) return write_heading(node, inner);
  if (type == CMARK_NODE_LINK) return write_link(node, inner);
  if (type == CMARK_NODE_ITEM) return with_named_box(inner);
  return "<div class=\"table\">" + aligned_by_class(inner) + "</div>\n";
}

std::string PageWriter::write_heading(cmark_node* node, const std::string& inner) {
  const int level = cmark_node_get_heading_level(node);
  const auto heading =
      std::find_if(context_.lesson.headings.begin(), context_.lesson.headings.end(),
                   [&](const Heading& one) { return one.node == node; });
  const std::string id = heading != context_.lesson.headings.end() ? heading->id : "";
  // One in a demo shows what a heading looks like, and is no part of this page.
  const bool in_demo = heading != context_.lesson.headings.end() && heading->in_demo;
  if (!in_demo) context_.list_heading(level, id, inner);
  const std::string tag = "h" + std::to_string(level);
  return "<" + tag + " id=\"" + id + "\"><a class=\"anchor\" href=\"#" + id + "\">" + inner +
         "</a></" + tag + ">\n";
}

void PageWriter::tell_later(const nlohmann::json& quiz) {
  context_.answers.push_back(
      {{"quiz", {{"title", quiz["title"]}, {"questions", quiz["questions"]}}},
       {"solution", nullptr}});
}

void PageWriter::tell_later(const Callout& callout, const nlohmann::json& data) {
  if (callout.kind != "solution") return;
  // Its own title seldom says what it solves; the section's does.
  const nlohmann::json section = context_.contents.empty() ? "" : context_.contents.back()["title"];
  context_.answers.push_back({{"quiz", nullptr},
                              {"solution",
                               {{"section", section},
                                {"label", data["label"]},
                                {"title", data["title"]},
                                {"body", data["body"]}}}});
}

std::string PageWriter::write_link(cmark_node* node, const std::string& inner) const {
  const std::string target = cmark_node_get_url(node);
  std::string title = cmark_node_get_title(node);
  if (!title.empty()) title = " title=\"" + escape_html(title) + "\"";
  const auto resolved = resolve_link(context_.course, context_.lesson, target);
  if (!resolved || !resolved->url.empty()) {
    return "<a class=\"external\" href=\"" + escape_html(escaped_address(target)) + "\"" + title +
           ">" + inner + "</a>";
  }
  const std::string anchor = resolved->anchor.empty() ? "" : "#" + resolved->anchor;
  const std::string path =
      resolved->lesson != nullptr ? page_path(*resolved->lesson) : resolved->page;
  const bool here = path == context_.page.page && !anchor.empty();
  return "<a href=\"" + (here ? "" : context_.from_root(path)) + anchor + "\"" + title + ">" +
         inner + "</a>";
}

std::string PageWriter::write_term(const TermUse& term, const std::string& inner) const {
  const Glossary::Term* known =
      context_.course.glossary ? context_.course.glossary->find(term.key) : nullptr;
  if (known == nullptr) return inner;
  const std::string path = page_path(context_.course.glossary->page);
  std::string title;
  if (context_.page.definitions != nullptr) {
    title = " title=\"" + escape_html(context_.page.definitions->at(term.key)) + "\"";
  }
  return "<a class=\"term\" href=\"" +
         (path == context_.page.page ? "" : context_.from_root(path)) + "#" + known->id + "\"" +
         title + ">" + inner + "</a>";
}

std::string PageWriter::children_html(cmark_node* node) const {
  std::string inner;
  for (cmark_node* child = cmark_node_first_child(node); child != nullptr;
       child = cmark_node_next(child)) {
    inner += render_inline_html(child, context_.writer);
  }
  return inner;
}

// One that is displayed in the middle of a paragraph is no block there.
std::string PageWriter::write_math(cmark_node* node, const Math& math, std::size_t index) const {
  const auto* result = context_.results.get<FormulaResult>(index);
  const std::string markup = result != nullptr ? result->markup : escape_html(math.tex.text);
  if (cmark_node_get_type(node) == math_block_type()) {
    return "<div class=\"math display\">" + markup + "</div>\n";
  }
  const bool is_long = !math.display && result != nullptr && is_wide_formula(markup);
  const char* const how = math.display ? " display" : is_long ? " wide" : "";
  return "<span class=\"math" + std::string(how) + "\">" + markup + "</span>";
}

// What a program reports, the page's script quotes anew when a reader runs it.
std::string PageWriter::quotation(const InlineValue& value) const {
  const std::string& name = value.source.text;
  const std::vector<std::string>& models = context_.course.models;
  if (std::ranges::find(models, name) != models.end()) return "";
  std::string attributes = " data-quotes=\"" + escape_html(name) + "\" data-result=\"" +
                           escape_html(value.expression.text) + "\"";
  if (!value.format.text.empty()) attributes += " data-format=\"" + value.format.text + "\"";
  return attributes;
}

std::string PageWriter::write_value(const InlineValue& value, std::size_t index) const {
  const auto* result = context_.results.get<ValueResult>(index);
  if (result == nullptr) return "<code>" + escape_html(value.expression.text) + "</code>";
  return "<span class=\"value\"" + quotation(value) +
         " title=\"computed: " + escape_html(result->origin) + "\">" + escape_html(result->text) +
         "</span>";
}

std::string PageWriter::write_listing(nlohmann::json data) {
  if (data["code"].is_null()) return render("example", data);
  const auto code = std::exchange(data["code"], placeholder("code")).get<std::string>();
  std::string html = render("example", data);
  fill_in(html, "example", "code", "code", code);
  return html;
}

std::string PageWriter::write_block(cmark_node* node, std::size_t i, const std::string& inner) {
  const auto* image = context_.results.get<ImageResult>(i);
  const Cases cases{
      [&](const Math& math) { return write_math(node, math, i); },
      [&](const InlineValue& value) { return write_value(value, i); },
      [&](const TermUse& term) { return write_term(term, inner); },
      [&](const Example& example) { return write_listing(data_of(example, i, context_)); },
      [&](const Exercise& exercise) {
        const auto* result = context_.results.get<ExerciseResult>(i);
        if (result == nullptr) return std::string();
        return write_listing(data_of(exercise, *result, context_));
      },
      [&](const Unchecked& unchecked) { return write_listing(data_of(unchecked, context_)); },
      [&](const Snippet& snippet) { return write_listing(data_of(snippet, i, context_)); },
      [&](const Commands& commands) { return write_listing(data_of(commands, i, context_)); },
      [&](const ModelExcerpt& excerpt) { return write_listing(data_of(excerpt, context_)); },
      [&](const InlineModel& model) { return write_listing(data_of(model, i, context_)); },
      // The example above shows an output that does not stand apart.
      [&](const Output& output) {
        return output.apart ? write_listing(data_of(output, i, context_)) : "";
      },
      [&](const Image& shown) {
        return image != nullptr ? render("image", data_of(shown, *image, context_)) : "";
      },
      [&](const Io& io) { return render("io", data_of(io, context_)); },
      [&](const Callout& callout) {
        const nlohmann::json data = data_of(callout, inner, context_);
        tell_later(callout, data);
        return render("callout", data);
      },
      [&](const Lab& lab) { return render("lab", lab_data(lab, i, context_)); },
      [&](const Figure& figure) { return render("figure", figure_data(figure, i, context_)); },
      [&](const Plot& plot) { return render("plot", plot_data(plot, i, context_)); },
      [&](const Quiz& quiz) {
        const nlohmann::json data = quiz_data(quiz, i, context_);
        tell_later(data);
        return render("quiz", data);
      },
      [&](const Demo& demo) { return render("demo", data_of(demo, context_)); },
      [](const Shown&) { return std::string(); },
  };
  return std::visit(cases, context_.lesson.blocks[i]);
}

}  // namespace mjcourse
