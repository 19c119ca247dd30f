#include "page/page_writer.h"

#include <stdexcept>
#include <utility>

#include "course/link_target.h"

namespace mjcourse {
namespace {

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

// The way from one lesson's page to a file below the site's root: pages lie one folder deep.
std::string from_lesson(const std::string& path) {
  return "../" + path;
}

}  // namespace

std::string render_template(Templates& templates, const std::string& name,
                            const nlohmann::json& data) {
  tl::expected<std::string, TemplateError> html = templates.render(name, data);
  if (html) return *std::move(html);
  const TemplateError& error = html.error();
  throw std::runtime_error("template " + error.name + ".hbs, line " + std::to_string(error.line) +
                           ": " + error.message);
}

std::string page_path(const Lesson& lesson) {
  return lesson.folder + "/" + lesson.slug + ".html";
}

std::string poster_path(const Lesson& lesson, int lab) {
  return lesson.folder + "/" + lesson.slug + "/lab-" + std::to_string(lab);
}

std::string table_path(const Lesson& lesson, int chart) {
  return lesson.folder + "/" + lesson.slug + "/plot-" + std::to_string(chart) + ".csv";
}

PageWriter::PageWriter(const Course& course, const Lesson& lesson, const LessonResults& results,
                       Press press)
    : course_(course), lesson_(lesson), results_(results), press_(press) {
  writer_.takes = [this](cmark_node* node) { return takes(node); };
  writer_.write = [this](cmark_node* node, const std::string& inner) { return write(node, inner); };
}

std::string PageWriter::body() {
  return html(lesson_.document);
}

std::string PageWriter::render(const std::string& name, const nlohmann::json& data) {
  return render_template(press_.templates, name, data);
}

bool PageWriter::takes(cmark_node* node) const {
  const cmark_node_type type = cmark_node_get_type(node);
  return lesson_.block(node) != nullptr || type == CMARK_NODE_HEADING || type == CMARK_NODE_LINK ||
         std::string(cmark_node_get_type_string(node)) == "table";
}

std::string PageWriter::write(cmark_node* node, const std::string& inner) {
  if (const auto block = lesson_.block_of.find(node); block != lesson_.block_of.end()) {
    return write_block(block->second, inner);
  }
  const cmark_node_type type = cmark_node_get_type(node);
  if (type == CMARK_NODE_HEADING) return write_heading(node, inner);
  if (type == CMARK_NODE_LINK) return write_link(node, inner);
  return "<div class=\"table\">" + aligned_by_class(inner) + "</div>\n";
}

std::string PageWriter::write_heading(cmark_node* node, const std::string& inner) {
  const int level = cmark_node_get_heading_level(node);
  std::string id;
  for (const Heading& heading : lesson_.headings) {
    if (heading.node == node) id = heading.id;
  }
  nlohmann::json entry{{"id", id}, {"title", inner}, {"children", nlohmann::json::array()}};
  if (level == 2 || contents_.empty()) {
    contents_.push_back(std::move(entry));
  } else if (level == 3) {
    contents_.back()["children"].push_back(std::move(entry));
  }
  const std::string tag = "h" + std::to_string(level);
  return "<" + tag + " id=\"" + id + "\"><a class=\"anchor\" href=\"#" + id + "\">" + inner +
         "</a></" + tag + ">\n";
}

std::string PageWriter::write_link(cmark_node* node, const std::string& inner) const {
  const std::string target = cmark_node_get_url(node);
  const auto resolved = resolve_link(course_, lesson_, target);
  const std::string anchor = resolved && !resolved->anchor.empty() ? "#" + resolved->anchor : "";
  if (!resolved || resolved->lesson == nullptr) {
    return "<a class=\"external\" href=\"" + escape_html(target) + "\">" + inner + "</a>";
  }
  const bool here = resolved->lesson == &lesson_ && !anchor.empty();
  const std::string page = here ? "" : from_lesson(page_path(*resolved->lesson));
  return "<a href=\"" + page + anchor + "\">" + inner + "</a>";
}

std::string PageWriter::write_block(std::size_t index, const std::string& inner) {
  const Block& block = lesson_.blocks[index];
  if (const auto* math = std::get_if<Math>(&block)) {
    const auto* result = results_.get<FormulaResult>(index);
    const std::string markup = result != nullptr ? result->markup : escape_html(math->tex.text);
    return math->display ? "<div class=\"math\">" + markup + "</div>\n"
                         : "<span class=\"math\">" + markup + "</span>";
  }
  if (const auto* value = std::get_if<InlineValue>(&block)) {
    const auto* result = results_.get<ValueResult>(index);
    if (result == nullptr) return "<code>" + escape_html(value->expression.text) + "</code>";
    return "<span class=\"value\" title=\"computed: " + escape_html(result->origin) + "\">" +
           escape_html(result->text) + "</span>";
  }
  if (const auto* example = std::get_if<Example>(&block)) {
    return render("example", data_of(*example, index));
  }
  if (const auto* unchecked = std::get_if<Unchecked>(&block)) {
    return render("example", data_of(*unchecked));
  }
  if (const auto* snippet = std::get_if<Snippet>(&block)) {
    return render("example", data_of(*snippet, index));
  }
  if (const auto* excerpt = std::get_if<ModelExcerpt>(&block)) {
    return render("example", data_of(*excerpt));
  }
  if (const auto* model = std::get_if<InlineModel>(&block)) {
    return render("example", data_of(*model, index));
  }
  if (const auto* lab = std::get_if<Lab>(&block)) return render("lab", data_of(*lab, index));
  if (const auto* chart = std::get_if<Chart>(&block)) {
    return render("plot", data_of(*chart, index));
  }
  if (const auto* quiz = std::get_if<Quiz>(&block)) return render("quiz", data_of(*quiz, index));
  if (const auto* io = std::get_if<Io>(&block)) return render("io", data_of(*io));
  if (const auto* callout = std::get_if<Callout>(&block)) {
    return render("callout", data_of(*callout, inner));
  }
  return "";  // an output and its label, which the example above shows
}

}  // namespace mjcourse
