#include "course/prerequisites.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "lesson/syntax/reading.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostNames = 3;  // in one message

// A use of a term or of a name of MuJoCo's.
struct Lean {
  std::string key;   // "[[state", "api:mj_step"
  std::string name;  // as a message has it
  Span span;
};

// In the order of the text.
std::vector<Lean> leans_of(const Lesson& lesson) {
  std::vector<Lean> leans;
  for (const Block& block : lesson.blocks) {
    if (const auto* term = std::get_if<TermUse>(&block)) {
      leans.push_back({"[[" + term->key, term->name.text, term->name.span()});
    }
  }
  for (const Link& link : lesson.links) {
    const std::string& target = link.target.text;
    if (target.starts_with("api:")) leans.push_back({target, target.substr(4), link.target.span()});
  }
  std::stable_sort(leans.begin(), leans.end(),
                   [](const Lean& a, const Lean& b) { return a.span.begin < b.span.begin; });
  return leans;
}

class Prerequisites {
 public:
  Prerequisites(const Course& course, Diagnostics& diagnostics)
      : course_(course), diagnostics_(diagnostics) {
    for (const Level& level : course.levels) {
      std::vector<std::size_t> earlier;
      for (const std::size_t index : level.lessons) {
        earlier_[index] = earlier;
        if (!level.number.empty() && !course.lessons[index].front.draft) {
          earlier.push_back(index);
          order_.push_back(index);
        }
      }
    }
    for (std::size_t index = 0; index < course.lessons.size(); ++index) {
      by_number_.try_emplace(course.lessons[index].number, index);
    }
  }

  void run() {
    for (const std::size_t index : order_) look_at(index);
  }

 private:
  void look_at(std::size_t index) {
    std::map<std::size_t, std::vector<Lean>> missing;  // by the lesson that explains them
    std::set<std::size_t> read;
    for (Lean& lean : leans_of(course_.lessons[index])) {
      const std::size_t first = explained_in_.try_emplace(lean.key, index).first->second;
      if (first == index) continue;
      if (read.empty()) read = read_before(index);
      if (read.contains(first)) continue;
      std::vector<Lean>& names = missing[first];
      const bool told =
          std::ranges::any_of(names, [&](const Lean& n) { return n.key == lean.key; });
      if (!told) names.push_back(std::move(lean));
    }
    for (const auto& [first, names] : missing) tell(index, first, names);
  }

  // And `index` itself.
  std::set<std::size_t> read_before(std::size_t index) const {
    std::set<std::size_t> read;
    std::vector<std::size_t> open{index};
    while (!open.empty()) {
      const std::size_t one = open.back();
      open.pop_back();
      if (!read.insert(one).second) continue;
      const std::vector<std::size_t>& earlier = earlier_.at(one);
      open.insert(open.end(), earlier.begin(), earlier.end());
      for (const LocatedText& number : course_.lessons[one].front.prerequisites) {
        const auto found = by_number_.find(number.text);
        if (found != by_number_.end()) open.push_back(found->second);
      }
    }
    return read;
  }

  void tell(std::size_t index, std::size_t first, const std::vector<Lean>& names) {
    const Lesson& lesson = course_.lessons[index];
    const std::string& number = course_.lessons[first].number;
    std::string message;
    const std::size_t shown = std::min(names.size(), kMostNames);
    for (std::size_t i = 0; i < shown; ++i) {
      if (i > 0) message += i + 1 < names.size() ? ", " : " and ";
      message += "`" + names[i].name + "`";
    }
    if (names.size() > shown) message += " and " + std::to_string(names.size() - shown) + " more";
    message += names.size() == 1 ? " is" : " are";
    message += " first explained in " + number +
               ", which is neither earlier in this level nor a prerequisite";
    std::string list;
    for (const LocatedText& known : lesson.front.prerequisites) list += known.text + ", ";
    Reading(*lesson.source, diagnostics_)
        .warning("W-prerequisite", names.front().span, message,
                 "let this lesson's front matter have `prerequisites: [" + list + number + "]`");
  }

  const Course& course_;
  Diagnostics& diagnostics_;
  std::vector<std::size_t> order_;  // of the lessons that explain
  std::unordered_map<std::size_t, std::vector<std::size_t>> earlier_;  // in the same level
  std::unordered_map<std::string, std::size_t> by_number_;
  std::unordered_map<std::string, std::size_t> explained_in_;  // by Lean::key
};

}  // namespace

void warn_of_missing_prerequisites(const Course& course, Diagnostics& diagnostics) {
  const bool known = std::ranges::any_of(
      course.lessons, [](const Lesson& lesson) { return !lesson.front.prerequisites.empty(); });
  if (known) Prerequisites(course, diagnostics).run();
}

}  // namespace mjcourse
