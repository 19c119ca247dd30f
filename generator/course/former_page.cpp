#include "course/former_page.h"

#include <algorithm>
#include <string_view>

#include "base/plain_name.h"
#include "base/utf8.h"
#include "course/level_folder.h"

namespace mjcourse {
namespace {

constexpr std::string_view kEnd = ".html";

// A folder's or a file's name that an address has as it is, and that hides nothing.
bool is_name(std::string_view text) {
  const auto plain = [](char c) { return is_word_character(c) || c == '-' || c == '.'; };
  return std::ranges::all_of(text, plain) && !fault_of_name(text);
}

bool is_folder(std::string_view text) {
  return is_name(text) && !ends_as_a_file(std::string(text));
}

std::string page_of(const Lesson& lesson) {
  return lesson.folder + "/" + lesson.slug + std::string(kEnd);
}

}  // namespace

std::optional<std::string> former_page(const Lesson& lesson, const std::string& written) {
  std::string_view path = written;
  if (path.ends_with(kEnd)) path.remove_suffix(kEnd.size());
  const std::size_t slash = path.find('/');
  const bool bare = slash == path.npos;
  if (!is_name(bare ? path : path.substr(slash + 1))) return std::nullopt;
  if (!bare && !is_folder(path.substr(0, slash))) return std::nullopt;
  return (bare ? lesson.folder + "/" : "") + std::string(path) + std::string(kEnd);
}

FormerPages::FormerPages(const Course& course) : course_(course) {
  for (const Lesson& lesson : course.lessons) {
    lessons_.try_emplace(page_of(lesson), &lesson);
    for (std::size_t i = 0; i < lesson.front.formerly.size(); ++i) {
      const auto page = former_page(lesson, lesson.front.formerly[i].text);
      if (page) claims_.try_emplace(*page, Claim{&lesson, i});
    }
  }
}

std::optional<DeadLink> FormerPages::fault(const Lesson& lesson, std::size_t index) const {
  const std::string& written = lesson.front.formerly[index].text;
  const std::optional<std::string> page = former_page(lesson, written);
  if (!page) {
    return DeadLink{"E-formerly-path",
                    "`" + written + "` is not an address that a page here can have",
                    "write the lesson's former file name, `1.2-old-name`, or its folder as well, "
                    "`1-state/1.2-old-name`"};
  }
  if (const auto there = lessons_.find(*page); there != lessons_.end()) {
    return there->second == &lesson
               ? DeadLink{"E-formerly-taken", *page + " is where this lesson is now",
                          "leave it out; only addresses that it had before are listed"}
               : DeadLink{"E-formerly-taken", "lesson " + there->second->number + " is at " + *page,
                          "leave it out, or give that lesson another name"};
  }
  const bool is_model = std::ranges::any_of(
      course_.models, [&](const std::string& model) { return model_page_path(model) == *page; });
  if (is_model) {
    return DeadLink{"E-formerly-taken", "the page of a model is at " + *page, "leave it out"};
  }
  const Claim& first = claims_.at(*page);
  if (first.lesson == &lesson && first.index == index) return std::nullopt;
  return DeadLink{"E-formerly-twice",
                  first.lesson == &lesson
                      ? *page + " is listed here twice"
                      : "lesson " + first.lesson->number + " was at " + *page + " as well",
                  "an old address leads to one lesson: keep it where most of its text is now"};
}

}  // namespace mjcourse
