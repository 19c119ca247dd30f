#include "lesson/syntax/raw_html.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <map>

#include "base/nearest.h"
#include "base/utf8.h"
#include "lesson/syntax/html_style.h"

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

// With the attributes that each may have besides those of all.
const std::map<std::string, Names, std::less<>>& elements() {
  static const std::map<std::string, Names, std::less<>> known{
      {"abbr", {}},
      {"b", {}},
      {"bdi", {}},
      {"bdo", {}},
      {"blockquote", {}},
      {"br", {}},
      {"caption", {}},
      {"cite", {}},
      {"code", {}},
      {"dd", {}},
      {"del", {}},
      {"details", {"open"}},
      {"dfn", {}},
      {"div", {}},
      {"dl", {}},
      {"dt", {}},
      {"em", {}},
      {"figcaption", {}},
      {"figure", {}},
      {"hr", {}},
      {"i", {}},
      {"ins", {}},
      {"kbd", {}},
      {"li", {"value"}},
      {"mark", {}},
      {"ol", {"reversed", "start", "type"}},
      {"p", {}},
      {"pre", {}},
      {"q", {}},
      {"rp", {}},
      {"rt", {}},
      {"ruby", {}},
      {"s", {}},
      {"samp", {}},
      {"small", {}},
      {"span", {}},
      {"strong", {}},
      {"sub", {}},
      {"summary", {}},
      {"sup", {}},
      {"table", {}},
      {"tbody", {}},
      {"td", {"colspan", "rowspan"}},
      {"tfoot", {}},
      {"th", {"colspan", "rowspan", "scope"}},
      {"thead", {}},
      {"tr", {}},
      {"u", {}},
      {"ul", {}},
      {"var", {}},
      {"wbr", {}},
  };
  return known;
}

constexpr std::array kOfAll{"class", "dir", "lang", "style", "title"};

// Of `a<b and c>d`, which was no tag to its author.
constexpr const char* kAsText = "leave it out; for `<` as text, write code, `` `a<b` ``, or `\\<`";

// What Markdown has in the place of the element `name`, which stands there as `written`.
std::string instead_of(const std::string& name, std::string_view written) {
  static const std::map<std::string, std::string, std::less<>> instead{
      {"a",
       "write a link: `[text](https://…)`; to link to a place, give it a heading, "
       "`[text](#its-words)`"},
      {"h1", "write a heading: `## …`"},
      {"h2", "write a heading: `## …`"},
      {"h3", "write a heading: `### …`"},
      {"h4", "write a heading: `#### …`"},
      {"h5", "write a heading: `#### …`"},
      {"h6", "write a heading: `#### …`"},
      {"img", "show a picture: `![what it shows](picture.png)`"},
      {"script",
       "what moves in a lesson is a lab or a figure; for the tag as text, write "
       "`&lt;script>`"},
      {"style", "give the element its `style=\"…\"`, or the course a theme/style.css"},
      {"svg", "put the drawing beside the lesson: `![what it shows](drawing.svg)`"},
  };
  const auto found = instead.find(name);
  if (found != instead.end()) return found->second;
  const std::string tag = "<" + std::string(written) + ">";
  return "leave it out; for the tag as text, write it as code, `` `" + tag + "` ``, or `\\" + tag +
         "`";
}

struct Words {
  const char *message, *cure;
};

constexpr Words kBroken{
    "this is no whole tag and no whole comment",
    "end it with `>`, its values in quotes; for the character as text, write `&lt;`"};
constexpr Words kDeclaration{"a lesson cannot have a declaration of HTML or XML",
                             "leave it out; to show it, write it as code"};
constexpr Words kUnclosed{"this comment is never closed",
                          "write `-->` where it ends; for the characters as text, `&lt;!--`"};
constexpr Words kEndsEarly{"to a browser, this comment ends before its `-->`",
                           "begin it with a space, and write no `--!>` in it"};

bool is_name_character(char c) {
  return is_word_character(c) || c == '-' || c == ':';
}

bool is_in(char c, std::string_view characters) {
  return characters.find(c) != characters.npos;
}

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n';
}

class HtmlReader {
 public:
  HtmlReader(std::string_view html, std::set<std::string>& refused)
      : html_(html), refused_(refused) {}

  std::vector<HtmlFault> faults() {
    while ((at_ = html_.find('<', at_)) < html_.size()) {
      const std::size_t begin = at_;
      const std::string_view rest = html_.substr(at_);
      const Words* broken = rest.starts_with("<!--")                  ? comment()
                            : rest.size() > 1 && is_in(rest[1], "!?") ? &kDeclaration
                            : autolink() || tag()                     ? nullptr
                                                                      : &kBroken;
      if (broken == nullptr) continue;
      refuse(begin, std::min(html_.find('\n', begin), html_.size()), "E-html-broken",
             broken->message, broken->cure);
      break;  // where the next begins, only a browser's rules for broken HTML could tell
    }
    return std::move(faults_);
  }

 private:
  void refuse(std::size_t begin, std::size_t end, const char* id, const std::string& message,
              const std::string& cure) {
    faults_.push_back({begin, end, id, message, cure});
  }

  // Browsers end a comment also at `--!>`, and one that begins with `>` or `->` at once.
  const Words* comment() {
    const std::size_t text = at_ + 4, end = html_.find("-->", text);
    const std::string_view inner = html_.substr(text, std::min(end, html_.size()) - text);
    if (inner.starts_with('>') || inner.starts_with("->") || inner.find("--!>") != inner.npos) {
      return &kEndsEarly;
    }
    if (end == html_.npos) return &kUnclosed;
    at_ = end + 3;
    return nullptr;
  }

  // `<https://…>`, which is a link in Markdown alone.
  bool autolink() {
    static const RE2 form(R"(<[A-Za-z][A-Za-z0-9+.-]+:[^\s<>"'=]*>)");
    re2::StringPiece rest(html_.data() + at_, html_.size() - at_);
    if (!RE2::Consume(&rest, form)) return false;
    const std::size_t begin = at_;
    at_ = html_.size() - rest.size();
    refuse(begin, at_, "E-html-hidden",
           "a link right beside a tag is not Markdown, and a browser would not show it",
           "leave an empty line between the tag and it; for `<` as text, write `&lt;`");
    return true;
  }

  bool tag() {
    const std::size_t begin = at_++;
    const bool closes = skip("/");
    const std::string_view written = word();
    const std::string name = lower(written);
    if (name.empty()) return false;
    const std::size_t name_end = at_;
    std::vector<HtmlFault> found;
    while (skip_blanks()) {
      const std::size_t attribute = at_;
      if (word().empty()) break;
      if (closes || !value(name, attribute, found)) return false;
    }
    if (!closes) skip("/");
    if (!skip(">")) return false;
    if (elements().contains(name)) {
      faults_.insert(faults_.end(), found.begin(), found.end());
    } else if (const bool is_first = refused_.insert(name).second; is_first || !closes) {
      // An end is refused with its beginning.
      refuse(begin, name_end, "E-html-element",
             "a lesson cannot have the element `" + std::string(written) + "`",
             instead_of(name, written));
    }
    return true;
  }

  // The value of the attribute that begins at `begin`, behind its name.
  bool value(const std::string& element, std::size_t begin, std::vector<HtmlFault>& found) {
    const std::string name = lower(html_.substr(begin, at_ - begin));
    const std::size_t name_end = at_;
    std::size_t start = at_, end = at_;
    skip_blanks();
    if (skip("=")) {
      skip_blanks();
      const char quote = at_ < html_.size() ? html_[at_] : '\0';
      if (quote != '"' && quote != '\'') return false;
      start = ++at_;
      end = html_.find(quote, start);
      if (end == html_.npos) return false;
      at_ = end + 1;
    } else {
      at_ = name_end;  // the blanks are those before the next attribute
    }
    const bool known = is_known(element, name);
    if (!known) found.push_back(unknown(element, name, begin, name_end));
    if (!known && end == name_end) found.back().cure = kAsText;
    if (!known || name != "style") return true;
    if (auto fault = style_fault(html_.substr(start, end - start))) {
      found.push_back(
          {start + fault->begin, start + fault->end, "E-html-style", fault->message, fault->cure});
    }
    return true;
  }

  static bool is_known(const std::string& element, const std::string& name) {
    if (std::find(kOfAll.begin(), kOfAll.end(), name) != kOfAll.end()) return true;
    const auto found = elements().find(element);
    return found != elements().end() &&
           std::find(found->second.begin(), found->second.end(), name) != found->second.end();
  }

  static HtmlFault unknown(const std::string& element, const std::string& name, std::size_t begin,
                           std::size_t end) {
    Names known(kOfAll.begin(), kOfAll.end());
    if (const auto own = elements().find(element); own != elements().end()) {
      known.insert(known.end(), own->second.begin(), own->second.end());
    }
    return {begin, end, "E-html-attribute",
            "in a lesson, the element `" + element + "` cannot have `" + name + "`",
            name == "id" || name == "name"
                ? "to link to a place, give it a heading: `[text](#its-words)`"
                : suggest(name, known)};
  }

  std::string_view word() {
    const std::size_t begin = at_;
    if (at_ < html_.size() && is_letter(html_[at_])) {
      while (at_ < html_.size() && is_name_character(html_[at_])) ++at_;
    }
    return html_.substr(begin, at_ - begin);
  }

  bool skip(std::string_view text) {
    if (!html_.substr(std::min(at_, html_.size())).starts_with(text)) return false;
    at_ += text.size();
    return true;
  }

  bool skip_blanks() {
    const std::size_t begin = at_;
    while (at_ < html_.size() && is_blank(html_[at_])) ++at_;
    return at_ > begin;
  }

  static std::string lower(std::string_view text) {
    std::string name(text);
    for (char& c : name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return name;
  }

  std::string_view html_;
  std::size_t at_ = 0;
  std::set<std::string>& refused_;
  std::vector<HtmlFault> faults_;
};

}  // namespace

std::vector<HtmlFault> faults_of_html(std::string_view html, std::set<std::string>& refused) {
  return HtmlReader(html, refused).faults();
}

bool is_lesson_element(std::string_view name) {
  return elements().contains(name);
}

}  // namespace mjcourse
