#include "evaluate/programs/judge.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/counted.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMarkDigits = 16;

// Of checks that the solution's run does not make.
constexpr std::size_t kMostOthers = 100;

// "1.5", or "[ 1.5 2" of a vector. Nothing where that is no text of numbers.
std::optional<Found> found_in(const std::string& text) {
  Found found;
  const char* at = text.c_str();
  found.is_vector = *at == '[';
  if (found.is_vector) ++at;
  while (*at != '\0') {
    char* end = nullptr;
    found.numbers.push_back(std::strtod(at, &end));
    if (end == at) return std::nullopt;
    at = end;
  }
  return found.is_vector || found.numbers.size() == 1 ? std::optional(found) : std::nullopt;
}

bool is_near(const Found& value, const Found& expected, double tolerance) {
  return value.is_vector == expected.is_vector &&
         std::equal(value.numbers.begin(), value.numbers.end(), expected.numbers.begin(),
                    expected.numbers.end(),
                    [&](double a, double b) { return std::abs(a - b) <= tolerance; });
}

std::string printed(const char* form, double number) {
  char text[64];
  std::snprintf(text, sizeof text, form, number);
  return text;
}

// The words of the helper header (how_far() in mjcourse.hpp), which a page shows.
std::string how_far(double value, double expected, double tolerance) {
  return "it is " + printed("%.6g", value) + ", and should be " + printed("%.6g", expected) +
         " ± " + printed("%.2g", tolerance) + ": off by " +
         printed("%.2g", std::abs(value - expected));
}

std::string listed(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + printed("%.6g", number);
  return "[" + text + "]";
}

// A long vector is cut.
std::string shown(const Found& value) {
  constexpr std::size_t most = 7;
  if (!value.is_vector) return printed("%.6g", value.numbers[0]);
  if (value.numbers.size() > most) return "a vector of " + counted(value.numbers.size(), "number");
  return listed(value.numbers);
}

std::string how_far(const Found& value, const Found& expected, double tolerance) {
  const std::vector<double>&a = value.numbers, &b = expected.numbers;
  if (a.size() != b.size() || value.is_vector != expected.is_vector) {
    return "it has " + counted(a.size(), "number") + ", and should have " +
           std::to_string(b.size());
  }
  if (!value.is_vector) return how_far(a[0], b[0], tolerance);
  constexpr std::size_t few = 7;
  std::size_t most = 0;
  const auto off = [&](std::size_t i) { return std::abs(a[i] - b[i]); };
  for (std::size_t i = 1; i < a.size(); ++i) {
    if (std::isnan(off(i)) || off(i) > off(most)) most = i;
  }
  if (a.size() > few) {
    return "of its number [" + std::to_string(most) + "], " + how_far(a[most], b[most], tolerance);
  }
  return "it is " + listed(a) + ", and should be " + listed(b) + " ± " +
         printed("%.2g", tolerance) + ": off by " + printed("%.2g", off(most));
}

void not_reached(JudgedCheck& check) {
  check.holds = false;
  check.meaning = "it was not reached";
  check.found = "";
  check.calls = 0;
}

}  // namespace

struct Judge::Report {
  std::string what, meaning;
  double points = 0;
  int line = 0;
  bool is_end = false;                          // the program came to its end
  std::optional<bool> holds;                    // of a plain check
  std::optional<Found> value, expected, other;  // of one with numbers
  double tolerance = 0;

  // Nothing where that is no report.
  static std::optional<Report> read(std::string_view line);
  bool asks() const { return value.has_value(); }
};

std::optional<Judge::Report> Judge::Report::read(std::string_view line) {
  const json all = json::parse(line, nullptr, false);
  if (!all.is_object()) return std::nullopt;
  try {
    const auto numbers = [&](const char* name) {
      return all.contains(name) ? found_in(all.at(name).get<std::string>()) : std::nullopt;
    };
    Report report;
    report.is_end = all.contains("ended");
    if (report.is_end) return report;
    report.what = all.at("what").get<std::string>();
    report.meaning = all.at("meaning").get<std::string>();
    const json& points = all.at("points");
    report.points = points.is_number() ? std::max(0.0, points.get<double>()) : 0;
    report.line = all.at("line").get<int>();
    if (all.contains("holds")) report.holds = all.at("holds").get<bool>();
    report.value = numbers("value");
    report.expected = numbers("expected");
    report.other = numbers("other");
    if (const auto tolerance = numbers("tolerance")) report.tolerance = tolerance->numbers.at(0);
    return report.holds || report.value ? std::optional(std::move(report)) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

const Answers::Known* Answers::find(std::string_view what) const {
  const auto is = [&](const Known& known) { return known.check.what == what; };
  const auto found = std::ranges::find_if(checks, is);
  return found == checks.end() ? nullptr : &*found;
}

std::vector<JudgedCheck> Answers::not_reached() const {
  std::vector<JudgedCheck> all;
  for (const Known& known : checks) mjcourse::not_reached(all.emplace_back(known.check));
  return all;
}

bool Answers::hold() const {
  return std::ranges::all_of(checks, [](const Known& known) { return known.check.holds; });
}

std::string Answers::key() const {
  std::string all = is_ended ? "" : "not ended\n";
  for (const Known& known : checks) {
    all += json(known.check.what).dump(-1, ' ', true, json::error_handler_t::replace);
    for (const KnownCall& call : known.calls) {
      all += " " + std::to_string(call.order);
      if (!call.expected) continue;
      all += call.expected->is_vector ? "v" : "n";
      for (const double number : call.expected->numbers) all += printed(" %.17g", number);
      all += printed(" ± %.17g", call.tolerance);
    }
    all += "\n";
  }
  return all;
}

JudgedCheck& Judge::made(const Report& report) {
  const auto is = std::ranges::find(made_, report.what, &JudgedCheck::what);
  if (is != made_.end()) return *is;
  JudgedCheck& check = made_.emplace_back();
  static_cast<Check&>(check) = {report.what, true, report.meaning, "", report.points, report.line};
  check.is_its_word = report.holds.has_value() || report.other.has_value();
  if (answers_ == nullptr) known_.emplace_back();
  return check;
}

// Numbers are held against the same call of the solution's run. A program whose checks hold so far
// has made the same calls. Behind one that does not it may leave some out, so it is not known which
// one is meant: then any that is left may be.
bool Judge::judge_numbers(const Report& report, const Answers::Known& known, JudgedCheck& check) {
  if (!report.value) return false;
  const auto is_met = [&](const KnownCall& call) {
    return is_near(*report.value, *call.expected, call.tolerance);
  };
  if (std::ranges::all_of(made_, &JudgedCheck::holds)) {
    const auto index = static_cast<std::size_t>(check.calls) - 1;
    if (index >= known.calls.size()) {
      check.found = "the solution's run makes it " + counted(known.calls.size(), "time");
      return false;
    }
    const KnownCall& call = known.calls[index];
    order_ = call.order;
    if (is_met(call)) return true;
    check.found = how_far(*report.value, *call.expected, call.tolerance);
    return false;
  }
  const auto left = std::ranges::upper_bound(known.calls, order_, {}, &KnownCall::order);
  const auto met = std::find_if(left, known.calls.end(), is_met);
  if (met != known.calls.end()) {
    order_ = met->order;
    return true;
  }
  check.found = "it is " + shown(*report.value);
  check.found += left == known.calls.end()
                     ? ", and the solution's run makes this check no more"
                     : ", and the solution's run expects " + shown(*left->expected) + " next";
  return false;
}

// Whether this call holds; what it found is in `check`.
bool Judge::judge(const Report& report, JudgedCheck& check) {
  const auto near = [&](const Found& expected) {
    if (is_near(*report.value, expected, report.tolerance)) return true;
    check.found = how_far(*report.value, expected, report.tolerance);
    return false;
  };
  const Answers::Known* known = answers_ == nullptr ? nullptr : answers_->find(report.what);
  // A check that the solution has judged is not taken at the program's word.
  if (known != nullptr && !known->check.is_its_word) return judge_numbers(report, *known, check);
  if (report.holds) return *report.holds;
  if (report.other) return near(*report.other);
  return answers_ == nullptr && report.expected && near(*report.expected);
}

std::optional<Judge::Report> Judge::read(std::string_view line) {
  std::uint64_t mark = 0;
  const std::string_view digits = line.substr(0, kMarkDigits);
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), mark, 16);
  if (fault != std::errc() || end != line.data() + kMarkDigits) return std::nullopt;
  const std::string_view text = line.substr(kMarkDigits);
  const std::string numbered = std::to_string(number_++).append(text) + "\n";
  if (mark != sip_hash(mark_, numbered.data(), numbered.size())) return std::nullopt;
  return Report::read(text);
}

std::string Judge::hear(std::string_view line) {
  const auto report = is_forged_ ? std::nullopt : read(line);
  const std::size_t known = answers_ == nullptr ? made_.size() : answers_->checks.size();
  if (!report || made_.size() > known + kMostOthers) {
    is_forged_ = true;
    return "0";  // a program may wait for it
  }
  if (report->is_end) {
    is_ended_ = true;
    return "";
  }
  JudgedCheck& check = made(*report);
  ++check.calls;
  const std::string before = check.found;
  const bool holds = judge(*report, check);
  if (!check.holds) {
    check.found = before;  // of the first that did not hold
  } else if (!holds) {
    check.holds = false;
    check.meaning = report->meaning;
    check.line = report->line;
  }
  if (answers_ == nullptr) {
    known_[static_cast<std::size_t>(&check - made_.data())].calls.push_back(
        {++order_, report->expected, report->tolerance});
  }
  if (!report->asks()) return "";
  return holds ? "1" : "0";
}

std::vector<JudgedCheck> Judge::verdict() const {
  std::vector<JudgedCheck> all;
  const bool may_leave_out =
      is_ended_ && !std::ranges::all_of(made_, [](const auto& check) { return check.holds; });
  for (const Answers::Known& known : answers_->checks) {
    JudgedCheck& check = all.emplace_back(known.check);
    const auto is = std::ranges::find(made_, check.what, &JudgedCheck::what);
    if (is == made_.end()) {
      not_reached(check);
      continue;
    }
    check.calls = is->calls;
    check.holds = is->holds;
    check.meaning = is->meaning;
    check.found = is->found;
    const int due = known.check.calls;
    if (!check.holds || check.calls == due) continue;
    // How often a plain check is made may depend on what is checked.
    const bool is_cut = answers_->is_ended && !is_ended_ && check.calls < due;
    const bool is_otherwise = check.calls > due || !may_leave_out;
    if (check.is_its_word ? !is_cut : !is_otherwise) {
      // That the program came to its end otherwise is its word.
      if (check.calls < due) check.is_its_word = true;
      continue;
    }
    check.holds = false;
    check.found = "it was made " + counted(check.calls, "time") + ", and " + counted(due, "time") +
                  " with the solution";
  }
  for (const JudgedCheck& check : made_) {
    if (answers_->find(check.what) != nullptr) continue;
    all.push_back(check);
    all.back().points = 0;
  }
  return all;
}

Answers Judge::answers() const {
  Answers answers;
  answers.is_ended = is_ended_;
  for (std::size_t i = 0; i < made_.size(); ++i) {
    answers.checks.push_back({made_[i], known_[i].calls});
  }
  return answers;
}

}  // namespace mjcourse
