#include "course/link_target.h"

#include <algorithm>
#include <string_view>

#include "base/nearest.h"
#include "base/utf8.h"
#include "course/web_address.h"

namespace mjcourse {
namespace {

bool are_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_digit);
}

// "1.12", "A.2"
bool is_lesson_number(std::string_view text) {
  const std::size_t dot = text.find('.');
  if (dot == text.npos || !are_digits(text.substr(dot + 1))) return false;
  const std::string_view level = text.substr(0, dot);
  return are_digits(level) || (level.size() == 1 && level[0] >= 'A' && level[0] <= 'Z');
}

tl::expected<LinkTarget, DeadLink> heading_of(const Lesson& lesson, const std::string& anchor) {
  std::vector<std::string> ids;
  for (const Heading& heading : lesson.headings) ids.push_back(heading.id);
  if (!anchor.empty() && std::find(ids.begin(), ids.end(), anchor) == ids.end()) {
    return tl::unexpected(
        DeadLink{"E-link-anchor",
                 (lesson.number.empty() ? "the glossary" : "lesson " + lesson.number) +
                     " has no heading `#" + anchor + "`",
                 suggest(anchor, ids)});
  }
  return LinkTarget{&lesson, anchor, ""};
}

tl::expected<LinkTarget, DeadLink> model_of(const Course& course, const std::string& model) {
  const std::vector<std::string>& known = course.models;
  if (std::find(known.begin(), known.end(), model) != known.end()) {
    return LinkTarget{nullptr, "", "", model_page_path(model)};
  }
  return tl::unexpected(DeadLink{"E-model-unknown", "there is no model `" + model + "` in models/",
                                 suggest(model, known)});
}

}  // namespace

std::optional<DeadLink> dead_lesson(const Course& course, const Lesson& from,
                                    const std::string& number) {
  if (const Lesson* lesson = course.find_lesson(number)) {
    if (!lesson->front.draft || from.front.draft) return std::nullopt;
    return DeadLink{"E-link-dead", "lesson " + number + " is a draft, and not in the site",
                    "link to it when its `draft` is gone"};
  }
  std::vector<std::string> others;
  for (const Lesson& lesson : course.lessons) {
    if (&lesson != &from) others.push_back(lesson.number);
  }
  return DeadLink{"E-link-dead", "there is no lesson `" + number + "` in this course",
                  others.empty() ? "add it to content/course.yaml" : suggest(number, others)};
}

tl::expected<LinkTarget, DeadLink> resolve_link(const Course& course, const Lesson& from,
                                                const std::string& target) {
  for (const char* outside : {"https://", "http://", "mailto:"}) {
    if (has_scheme(target, outside)) return LinkTarget{nullptr, "", target};
  }
  if (target.starts_with("#")) return heading_of(from, target.substr(1));
  if (target.starts_with("model:")) return model_of(course, target.substr(6));
  if (target.starts_with("api:"))
    return LinkTarget{nullptr, api_id(target.substr(4)), "", kApiPage};
  const std::size_t hash = std::min(target.find('#'), target.size());
  const std::string number = target.substr(0, hash);
  if (is_lesson_number(number)) {
    if (const auto dead = dead_lesson(course, from, number)) return tl::unexpected(*dead);
    return heading_of(*course.find_lesson(number),
                      hash < target.size() ? target.substr(hash + 1) : "");
  }
  return tl::unexpected(DeadLink{
      "E-link-dead", target.empty() ? "this link has no address" : "`" + target + "` leads nowhere",
      "a link leads to a lesson (`1.3`, `1.3#heading`), to a heading of "
      "its own page (`#heading`), to a model (`model:NAME`), to a MuJoCo name (`api:mj_step`) or "
      "to the web (`https://…`)"});
}

std::optional<DeadLink> unknown_term(const Course& course, const TermUse& term) {
  if (!course.glossary) {
    return DeadLink{"E-term-unknown",
                    "this course has no glossary, and so no `" + term.name.text + "`",
                    std::string("write one, ") + kGlossaryPath +
                        ": front matter with a `title`, then a heading `## " + term.name.text +
                        "` and below it what that is; or write `\\[[` for brackets as text"};
  }
  if (course.glossary->find(term.key) != nullptr) return std::nullopt;
  // Compared without their case, and suggested as they are written.
  std::vector<std::string> keys;
  for (const Glossary::Term& known : course.glossary->terms) keys.push_back(known.key);
  const Glossary::Term* meant = course.glossary->find(nearest(term.key, keys));
  return DeadLink{"E-term-unknown", "the glossary has no term `" + term.name.text + "`",
                  meant != nullptr ? "did you mean `" + meant->name + "`?"
                                   : std::string("define it in ") + kGlossaryPath +
                                         ", or write `\\[[` for brackets as text; " +
                                         suggest(term.name.text, course.glossary->names())};
}

std::string model_page_path(const std::string& model) {
  return "models/" + model + ".html";
}

std::string api_id(const std::string& name) {
  std::string id = name;
  std::replace(id.begin(), id.end(), '.', '-');
  return id;
}

}  // namespace mjcourse
