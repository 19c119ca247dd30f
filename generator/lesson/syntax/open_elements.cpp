#include "lesson/syntax/open_elements.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "lesson/syntax/raw_html.h"

namespace mjcourse {
namespace {

constexpr std::array<std::string_view, 3> kWithoutContent{"br", "hr", "wbr"};

constexpr std::array<std::string_view, 13> kWithoutEnd{
    "caption", "dd", "dt", "li", "p", "rp", "rt", "tbody", "td", "tfoot", "th", "thead", "tr"};

template <std::size_t size>
bool is_one_of(const std::string& name, const std::array<std::string_view, size>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

void OpenElements::read(const HtmlTag& tag, cmark_node* parent, Span span, bool refused,
                        Reading& reading) {
  if (!known_ || !is_lesson_element(tag.name)) return;
  if (tag.closes) return close(tag, parent, span, reading);
  if (is_one_of(tag.name, kWithoutContent)) return;
  open_.push_back({tag.name, parent, span, refused});
  ++counts_[tag.name];
}

void OpenElements::give_up() {
  known_ = false;
  open_.clear();
  counts_.clear();
}

void OpenElements::close(const HtmlTag& tag, cmark_node* parent, Span span, Reading& reading) {
  if (counts_[tag.name] == 0) return refuse_end(tag, span, reading);
  const auto opened = std::find_if(open_.rbegin(), open_.rend(),
                                   [&](const Element& one) { return one.name == tag.name; });
  if (opened->parent != parent) {
    reading.error("E-html-nesting", span,
                  "`</" + tag.name + ">` stands in another paragraph, item or quote than its `<" +
                      tag.name + ">`",
                  "let an element end where it begins; around paragraphs, give both tags lines of "
                  "their own, with empty lines between");
    --counts_[tag.name];
    open_.erase(std::next(opened).base());
    return;
  }
  while (open_.back().name != tag.name) end_last(reading);
  --counts_[tag.name];
  open_.pop_back();
}

void OpenElements::refuse_end(const HtmlTag& tag, Span span, Reading& reading) {
  if (const auto told = refused_.find(tag.name); told != refused_.end()) {
    refused_.erase(told);
    return;
  }
  const bool is_empty = is_one_of(tag.name, kWithoutContent);
  reading.error("E-html-nesting", span, "`</" + tag.name + ">` closes nothing",
                is_empty ? "write `<" + tag.name + ">`"
                         : "leave it out, or open the element: `<" + tag.name + ">`");
}

void OpenElements::end(cmark_node* parent, Reading& reading) {
  while (!open_.empty() && open_.back().parent == parent) end_last(reading);
}

// The last that was opened ends where its end does not stand.
void OpenElements::end_last(Reading& reading) {
  const Element element = std::move(open_.back());
  open_.pop_back();
  --counts_[element.name];
  if (is_one_of(element.name, kWithoutEnd)) return;
  refused_.insert(element.name);
  if (element.refused) return;
  reading.error("E-html-nesting", element.span, "this `<" + element.name + ">` is never closed",
                "write `</" + element.name + ">` where it ends");
}

}  // namespace mjcourse
