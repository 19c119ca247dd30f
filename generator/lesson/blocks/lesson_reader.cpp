#include "lesson/blocks/lesson_reader.h"

#include <cmark-gfm/node.h>

#include <algorithm>
#include <string_view>

#include "lesson/blocks/callout.h"
#include "lesson/blocks/fence.h"
#include "lesson/blocks/read_image.h"
#include "lesson/blocks/read_losses.h"
#include "lesson/blocks/read_mere_text.h"
#include "lesson/blocks/read_value.h"
#include "lesson/syntax/doubtful_math.h"
#include "lesson/syntax/heading_id.h"
#include "lesson/syntax/picture_name.h"

namespace mjcourse {
namespace {

constexpr int kMostParts = 10'000;

// All nodes of the trees but text, the ends of lines, and cells, of which the tables keep count.
bool is_part(cmark_node* node) {
  return cmark_node_get_type(node) != CMARK_NODE_SOFTBREAK &&
         !std::string_view(cmark_node_get_type_string(node)).starts_with("table_");
}

// Are there but blanks and the marks of quotes before `at` on its line?
bool starts_line(const SourceText& source, std::size_t at) {
  const std::size_t start = source.line_start(source.position(at).line);
  return source.text().substr(start, at - start).find_first_not_of(" \t>") ==
         std::string_view::npos;
}

// Does the text that begins at `at` stand on a line of its own, below other text of its paragraph?
bool begins_line_below_text(cmark_node* text, const SourceText& source, std::size_t at) {
  cmark_node* paragraph = cmark_node_parent(text);
  return paragraph != nullptr && starts_line(source, at) &&
         source.position(at).line > cmark_node_get_start_line(paragraph);
}

// Does `node` stand in one of the type?
bool is_in(cmark_node* node, cmark_node_type type) {
  while ((node = cmark_node_parent(node)) != nullptr) {
    if (cmark_node_get_type(node) == type) return true;
  }
  return false;
}

}  // namespace

void LessonReader::read_document() {
  in_document_ = true;
  const LocatedText whole = located(source(), {0, source().text().size()});
  Region region{whole, 0};
  walk(lesson_.document.get(), region);
  in_document_ = false;
}

void LessonReader::refuse_excess(Excess excess, Span span) {
  if (excess == Excess::depth) {
    reading_.error("E-markdown-depth", span,
                   "lists, quotes or emphasis stand in one another here a hundred deep",
                   "give it fewer levels; for such characters as text, write `\\>` or `\\*`");
  } else if (excess == Excess::cells) {
    reading_.error("E-table-size", span,
                   "a table has at most 200 columns, and all tables of a lesson 10000 cells",
                   "show a part of it, or a plot; each row has a cell in each column");
  } else {
    reading_.error("E-reference-size", span,
                   "this reference with all links that may name it is more than 64 MiB",
                   "end it with an empty line, and give it a shorter address");
  }
}

// Has the file more parts than are read? Says so once, at the first.
bool LessonReader::is_too_much(const Region& region) {
  if (++parts_ == kMostParts + 1) {
    reading_.error("E-lesson-size", region.text.span(region.cursor, region.cursor + 1),
                   "a lesson has at most 10000 paragraphs, formulas, links and other parts in all",
                   "make several of it");
  }
  return parts_ > kMostParts;
}

Document LessonReader::parse(const std::string& text, int first_line) {
  const auto refuse = [&](Excess excess, int line) {
    const std::size_t start = source().line_start(std::max(line, 1));
    refuse_excess(excess, {start, start + 1});
  };
  Losses losses;
  Document document = parse_markdown(text, refuse, first_line, &losses, lesson_.typography);
  if (!losses.empty())
    tell_losses(losses, located(source(), {0, source().text().size()}), reading_);
  return document;
}

Document LessonReader::fragment(const LocatedText& text) {
  if (text.text.empty()) return nullptr;
  Losses losses;
  const auto refuse = [&](Excess excess, int) { refuse_excess(excess, text.span()); };
  Document document = parse_markdown(text.text, refuse, 1, &losses, lesson_.typography);
  tell_losses(losses, text, reading_);
  const bool outer = std::exchange(in_document_, false);
  Region region{text, 0};
  walk(document.get(), region);
  in_document_ = outer;
  return document;
}

void LessonReader::add(cmark_node* node, Block block) {
  lesson_.block_of[node] = lesson_.blocks.size();
  lesson_.blocks.push_back(std::move(block));
}

void LessonReader::walk(cmark_node* node, Region& region) {
  const cmark_node_type type = cmark_node_get_type(node);
  if (in_document_ && CMARK_NODE_TYPE_BLOCK_P(type) && cmark_node_get_start_line(node) > 0) {
    region.cursor = std::max(region.cursor, source().line_start(cmark_node_get_start_line(node)));
  }
  if (is_part(node) && is_too_much(region)) return;
  if (CMARK_NODE_TYPE_BLOCK_P(type)) {
    warn_of_mere_text(node, region.text, in_document_, lesson_, reading_);
  }
  if (type == CMARK_NODE_CODE_BLOCK) return read_code_block(node, region);
  if (type == math_inline_type() || type == math_block_type()) return read_math(node, region);
  if (type == CMARK_NODE_IMAGE) return read_image(node, region);
  if (type == CMARK_NODE_BLOCK_QUOTE) read_callout(node);
  if (type == CMARK_NODE_HEADING) read_heading(node, region);
  if (type == CMARK_NODE_FOOTNOTE_DEFINITION) return read_footnote(node, region);
  if (type == CMARK_NODE_CODE) read_code_span(node, region);
  const std::size_t behind = type == CMARK_NODE_LINK ? read_link(node, region) : 0;
  if (type == CMARK_NODE_FOOTNOTE_REFERENCE) refuse_footnote_in_link(node, region);
  if (type == CMARK_NODE_HTML_BLOCK || type == CMARK_NODE_HTML_INLINE) {
    read_html(node, find(cmark_node_get_literal(node), region), html_, reading_);
  }
  // The title of a callout was moved out of the tree, and is walked with it.
  if (const auto found = lesson_.block_of.find(node); found != lesson_.block_of.end()) {
    if (const auto* callout = std::get_if<Callout>(&lesson_.blocks[found->second])) {
      if (cmark_node* title = callout->title.get()) {
        in_callout_title_ = true;
        walk(title, region);
        in_callout_title_ = false;
      }
    }
  }
  walk_children(node, region);
  if (type == CMARK_NODE_HEADING) read_title(node);
  if (type == CMARK_NODE_BLOCK_QUOTE) read_source_of(node);
  region.cursor = std::max(region.cursor, behind);
}

void LessonReader::walk_children(cmark_node* node, Region& region) {
  for (cmark_node* child = cmark_node_first_child(node);
       child != nullptr && parts_ <= kMostParts;) {
    if (cmark_node_get_type(child) == CMARK_NODE_TEXT) {
      child = read_text(child, region);  // which may cut it into several
      continue;
    }
    cmark_node* next = cmark_node_next(child);
    walk(child, region);
    child = next;
  }
  html_.open.end(node, reading_);
}

// Find `text` at or after the region's cursor, line by line, since the lines of a quote are apart.
LocatedText LessonReader::find(const std::string& text, Region& region) {
  LocatedText found{text, {}};
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::size_t place = region.text.text.find(text.substr(at, end - at), region.cursor);
    // What cmark changed (an escape in a table's cell) is blamed on where the walk is.
    if (place == std::string::npos) {
      place = region.cursor;
    } else {
      region.cursor = place + (end - at);
    }
    const std::size_t size = end - at;
    const Offsets stood =
        region.text.part(place, std::min(place + size, region.text.text.size())).offsets;
    found.offsets.append(stood, 0, stood.size());
    found.offsets.append_still(size + 1 - stood.size(), region.text.span(place + size, 0).begin);
    at = end + 1;
  }
  return found;
}

void LessonReader::read_math(cmark_node* node, Region& region) {
  const MathText& math = math_text(node);
  const std::string dollars = math.display ? "$$" : "$";
  const LocatedText opened = find(dollars + math.tex, region);
  const LocatedText tex = opened.part(dollars.size(), opened.text.size());
  const bool is_end = math.display && std::exchange(math_is_cut_, false);
  if (!math.closed && !is_end) {
    reading_.error("E-math-unclosed", {tex.span().begin - 2, tex.span().begin},
                   "this `$$` is never closed", "end the formula with `$$`");
  }
  if (!math.behind.empty()) {
    reading_.error("E-math-behind", find(math.behind, region).span(),
                   "text stands behind the `$$` that closes the formula",
                   "begin it on a line of its own");
  }
  if (!math.display) warn_of_doubtful_math(tex);
  add(node, Math{tex, math.display});
}

void LessonReader::warn_of_doubtful_math(const LocatedText& tex) {
  const std::string_view text = source().text();
  const Span span = tex.span();
  const auto is_dollar = [&](std::size_t at) { return at < text.size() && text[at] == '$'; };
  if (!is_dollar(span.begin - 1) || !is_dollar(span.end)) return;  // it was not found
  const char before = span.begin > 1 ? text[span.begin - 2] : '\0';
  if (!is_doubtful_math(before, tex.text, text.substr(span.end + 1))) return;
  reading_.warning("W-math-doubtful", {span.begin - 1, span.end + 1},
                   "between these two dollars stands a formula, though it looks like text",
                   "for a dollar as text, write `\\$`, or code; for the formula, set it apart from "
                   "the words around it");
}

void LessonReader::read_code_span(cmark_node* node, Region& region) {
  const std::string code = cmark_node_get_literal(node);
  if (!is_value(code)) return pass_code_span(code, region);
  std::optional<InlineValue> value = read_value(find(code, region), reading_);
  if (value) add(node, *std::move(value));
}

// What stands in code is no term and no value: the walk goes on behind it. Code that cmark changed
// (a line break in it) is not found in its paragraph.
void LessonReader::pass_code_span(const std::string& code, Region& region) {
  const std::string& text = region.text.text;
  const std::string_view here(text.data(), std::min(text.find("\n\n", region.cursor), text.size()));
  for (std::size_t at = region.cursor; (at = here.find(code, at)) < here.size(); ++at) {
    const std::size_t before = at == 0 ? text.npos : text.find_last_not_of(' ', at - 1);
    if (before == text.npos || text[before] != '`') continue;
    region.cursor = at + code.size();
    return;
  }
}

// Gives where the walk goes on behind a target that stands behind the link's text, so that it is
// not taken for that of the next link. The target of a link by reference stands in its definition.
std::size_t LessonReader::read_link(cmark_node* node, const Region& region) {
  const std::string target = cmark_node_get_url(node);
  const std::string& text = region.text.text;
  const std::size_t end = std::min(text.find("\n\n", region.cursor), text.size());
  const std::string_view here = std::string_view(text).substr(0, end);
  const std::string shown = plain_text(node), words = "[" + shown + "]";
  if (target == shown || target == "mailto:" + shown) {
    const std::size_t opened = here.find("<" + shown + ">", region.cursor);
    const std::size_t bracket = here.find(words, region.cursor);
    if (opened < bracket) return read_autolink(node, {region.text, opened + 1});
  }
  std::size_t at = here.find(words + "(" + target, region.cursor);
  if (at != here.npos) {
    at += words.size() - 1;
  } else if (here.find(words, region.cursor) == here.npos) {
    at = here.find("](" + target, region.cursor);  // there is markup in its text
  }
  const bool is_behind = at != here.npos;
  if (!is_behind) at = text.find("]: " + target);
  Region ahead{region.text, at == text.npos ? region.cursor : text.find(target, at)};
  lesson_.links.push_back({node, find(target, ahead)});
  refuse_empty_link(node, lesson_.links.back().target.span());
  refuse_link_in_heading(node);
  return is_behind ? at + 2 + target.size() : region.cursor;
}

// `<https://…>`, whose words begin at the region's cursor.
std::size_t LessonReader::read_autolink(cmark_node* node, Region words) {
  LocatedText target = find(plain_text(node), words);
  target.text = cmark_node_get_url(node);  // may begin with a `mailto:` that is not written
  target.offsets.append_still(target.text.size() + 1 - target.offsets.size(),
                              target.offsets.back());
  lesson_.links.push_back({node, std::move(target), true});
  refuse_link_in_heading(node);
  return words.cursor;
}

void LessonReader::refuse_link_in_heading(cmark_node* node) {
  if (!is_in(node, CMARK_NODE_HEADING)) return;
  reading_.error("E-link-place", lesson_.links.back().target.span(),
                 "a link cannot stand in a heading, which is a link itself",
                 "put it into the text below");
}

// Nobody sees it.
void LessonReader::refuse_empty_link(cmark_node* node, Span target) {
  const std::string words = plain_text(node);
  if (words.find_first_not_of(" \t") != words.npos) return;
  cmark_node* child = cmark_node_first_child(node);
  while (child != nullptr && cmark_node_get_type(child) != CMARK_NODE_IMAGE) {
    child = cmark_node_next(child);
  }
  if (child != nullptr) return;
  reading_.error("E-link-text", target, "this link has no words, so nobody sees it",
                 "write them between its brackets: `[words](…)`");
}

void LessonReader::refuse_footnote_in_link(cmark_node* node, const Region& region) {
  const bool in_heading = is_in(node, CMARK_NODE_HEADING);
  if (!in_heading && !is_in(node, CMARK_NODE_LINK)) return;
  Region ahead{region.text, region.cursor};
  const cmark_chunk& label =
      (node->parent_footnote_def != nullptr ? node->parent_footnote_def : node)->as.literal;
  const std::string mark =
      "[^" +
      std::string(reinterpret_cast<const char*>(label.data), static_cast<std::size_t>(label.len)) +
      "]";
  reading_.error("E-footnote-place", find(mark, ahead).span(),
                 in_heading ? "a footnote's mark cannot stand in a heading, which is a link itself"
                            : "a footnote's mark cannot stand in the text of a link",
                 in_heading ? "put it into the text below" : "put it behind the link");
}

void LessonReader::read_heading(cmark_node* node, const Region& region) {
  if (!in_document_) {
    reading_.error("E-heading-nested", region.text.span(),
                   "Markdown inside JSON cannot hold a heading", "use bold text: `**…**`");
    return;
  }
  const int level = cmark_node_get_heading_level(node);
  if (level == 1) {
    const std::size_t start = source().line_start(cmark_node_get_start_line(node));
    reading_.error("E-heading-level", {start, start + 1},
                   "a lesson's own headings begin at the second level (`##`)",
                   "the page's first heading is the `title` of the front matter");
  }
  const std::string slug = id_of_heading(plain_text(node));
  std::string id = slug;
  while (!heading_ids_.insert(id).second) {
    int& number = heading_numbers_.try_emplace(slug, 1).first->second;
    id = slug + "-" + std::to_string(++number);
  }
  lesson_.headings.push_back({level, id, node, in_demo_, cmark_node_get_start_line(node)});
}

// Its text, once what stands in it was read.
void LessonReader::read_title(cmark_node* heading) {
  if (!in_document_) return;
  add_title_parts(heading, lesson_.headings.back().title);
}

void LessonReader::add_title_parts(cmark_node* node, std::vector<TitlePart>& title) const {
  const auto block = lesson_.block_of.find(node);
  if (block != lesson_.block_of.end() &&
      (std::holds_alternative<InlineValue>(lesson_.blocks[block->second]) ||
       std::holds_alternative<Math>(lesson_.blocks[block->second]))) {
    title.push_back({plain_text(node), block->second});
    return;
  }
  cmark_node* child = cmark_node_first_child(node);
  if (child == nullptr) title.push_back({plain_text(node), std::nullopt});
  for (; child != nullptr; child = cmark_node_next(child)) add_title_parts(child, title);
}

// cmark moves footnotes to the end of the tree, where they stand by their first mention. So each is
// looked for from where it begins.
void LessonReader::read_footnote(cmark_node* node, const Region& region) {
  const int line = cmark_node_get_start_line(node);
  Region own{region.text, 0};
  if (in_document_) {
    refuse_second_footnote(node);
    own.cursor = source().line_start(line);
  } else {
    for (int i = 1; i < line; ++i) own.cursor = region.text.text.find('\n', own.cursor) + 1;
  }
  walk_children(node, own);
}

// cmark sees to the names of one document; a demo is one of its own, on the same page.
void LessonReader::refuse_second_footnote(cmark_node* node) {
  const cmark_chunk& label = node->as.literal;
  const std::string name(reinterpret_cast<const char*>(label.data),
                         static_cast<std::size_t>(label.len));
  if (footnotes_.insert(name).second) return;
  const int line = cmark_node_get_start_line(node);
  const std::size_t at = source().line_start(line);
  const std::size_t end = source().line(line).find(']');
  mjcourse::refuse_second_footnote(name, {at, at + (end == std::string_view::npos ? 1 : end + 1)},
                                   reading_);
}

void LessonReader::read_callout(cmark_node* node) {
  if (!in_document_) return;
  if (std::optional<Callout> callout = take_callout(node, reading_)) add(node, std::move(*callout));
}

void LessonReader::read_image(cmark_node* node, Region& region) {
  // The text of the picture, which may hold the file's name as well, stands before it.
  const std::size_t target = region.text.text.find("](", region.cursor);
  if (target != std::string::npos) region.cursor = target + 2;
  const LocatedText file = file_of_target(find(cmark_node_get_url(node), region));
  const bool alone = stands_alone(node);
  std::optional<Image> image = mjcourse::read_image(node, file, alone, reading_);
  if (image) add(alone ? cmark_node_parent(node) : node, *std::move(image));
}

// Is the picture a whole paragraph of the lesson's own text?
bool LessonReader::stands_alone(cmark_node* node) const {
  cmark_node* paragraph = cmark_node_parent(node);
  if (!in_document_ || cmark_node_get_type(paragraph) != CMARK_NODE_PARAGRAPH) return false;
  if (cmark_node_next(node) != nullptr || cmark_node_previous(node) != nullptr) return false;
  return !in_callout_title_;
}

// Where a callout's claim is from, once what stands in it was read.
void LessonReader::read_source_of(cmark_node* quote) {
  const auto found = lesson_.block_of.find(quote);
  if (found == lesson_.block_of.end()) return;
  if (auto* callout = std::get_if<Callout>(&lesson_.blocks[found->second])) {
    callout->source = source_in(quote);
  }
}

void LessonReader::refuse_unclosed_math(cmark_node* node, const Region& region) {
  if (std::string_view(cmark_node_get_literal(node)).find("$$") == std::string_view::npos) return;
  Region ahead{region.text, region.cursor};
  const Span span = find("$$", ahead).span();
  const bool below_text = in_document_ && begins_line_below_text(node, source(), span.begin);
  // Its end is the second that is not closed: of a formula that a list or a quote cut in two.
  const bool is_end = std::exchange(math_is_cut_, below_text && !math_is_cut_);
  if (is_end && starts_line(source(), span.begin)) return;
  reading_.error(
      "E-math-unclosed", span, "this `$$` is never closed",
      below_text
          ? "leave an empty line above it: right below text, the formula ends where a list, a "
            "quote "
            "or a heading may begin, at a line with `-`, `+`, `>` or `#`; then end it with `$$`"
          : "end the formula with `$$`; for dollars as text write `\\$\\$`");
}

void LessonReader::read_code_block(cmark_node* node, Region& region) {
  if (in_document_) return read_fence(node, region);
  reading_.error("E-fence-nested", region.text.span(),
                 "Markdown inside JSON cannot hold a code block", "use a code span: `…`");
}

}  // namespace mjcourse
