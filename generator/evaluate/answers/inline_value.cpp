#include "evaluate/answers/inline_value.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "base/nearest.h"
#include "evaluate/context/script_place.h"
#include "script/world.h"

namespace mjcourse {
namespace {

static_assert(std::numeric_limits<long double>::digits >= 64);  // as an integer of a program has

// As it was computed: a double, or an integer of a program.
struct Number {
  template <typename Computed>
  explicit Number(Computed computed)
      : value(computed),
        is_whole(std::is_integral_v<Computed> ||
                 // From 2^53 on, not every whole number is a double.
                 (value == std::floor(value) && std::abs(value) < 0x1p53)) {}
  long double value;
  bool is_whole;
};

// `number` as printf prints it: a whole one plainly and another with six digits, unless `format`
// asks for something else.
std::string number_in_text(const Number& number, const std::string& format) {
  const bool plainly = format.empty() ? number.is_whole : format == "d";
  std::string form = plainly ? "%.0f" : "%" + (format.empty() ? ".6g" : format);
  form.insert(form.size() - 1, "L");
  const long double x = number.value;
  const int size = std::snprintf(nullptr, 0, form.c_str(), x);
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  std::snprintf(text.data(), text.size(), form.c_str(), x);
  text.pop_back();
  const bool nothing = text.substr(0, text.find('e')).find_first_of("123456789") == text.npos;
  return nothing && text.starts_with('-') ? text.substr(1) : text;
}

class Quotation {
 public:
  Quotation(const InlineValue& value, const Lesson& lesson, WorkerContext& worker_context,
            Diagnostics& diagnostics)
      : value_(value),
        lesson_(lesson),
        worker_context_(worker_context),
        diagnostics_(diagnostics) {}

  std::optional<ValueResult> run() {
    const std::string& name = value_.source.text;
    std::vector<std::string> known = worker_context_.course().models;
    const bool model = std::find(known.begin(), known.end(), name) != known.end();
    const std::vector<std::string> examples = worker_context_.reports_of(name).examples();
    const bool example = std::find(examples.begin(), examples.end(), name) != examples.end();
    if (model == example) {
      known.insert(known.end(), examples.begin(), examples.end());
      return model ? error("E-value-source", value_.source,
                           "`" + name + "` is a model and an example", "give one another name")
                   : error("E-value-source", value_.source,
                           "there is no model or example `" + name + "`", suggest(name, known));
    }
    return model ? of_model() : of_example();
  }

 private:
  std::optional<ValueResult> of_model() {
    auto simulation = worker_context_.simulate(value_.source, *lesson_.source, diagnostics_);
    if (!simulation) return std::nullopt;
    World world(worker_context_.world_bundle(), *simulation);
    const auto found = world.value(value_.expression.text);
    if (!found) {
      diagnostics_.push_back(script_diagnostic(found.error(), value_.expression, *lesson_.source));
      return std::nullopt;
    }
    const std::string origin = value_.expression.text + " of " + value_.source.text + ".xml";
    const nlohmann::json& json = *found;
    if (json.is_string()) return text(json.get<std::string>(), origin);
    if (json.is_array() && json.size() == 1 && json[0].is_number()) {
      return number(Number(json[0].get<double>()), origin);
    }
    if (json.is_number()) return number(Number(json.get<double>()), origin);
    return json.is_array() ? vector(json.size(), "choose one of them, as `qpos('hinge')[0]`")
                           : error("E-value-kind", value_.expression,
                                   "this is true or false; the text takes a number", "");
  }

  std::optional<ValueResult> of_example() {
    const auto found = worker_context_.reports_of(value_.source.text)
                           .find(value_.source, value_.expression, *lesson_.source, diagnostics_);
    if (!found) return std::nullopt;
    const std::string origin = value_.expression.text + " of " + value_.source.text + ".cpp";
    return std::visit([&](const auto& reported) { return quoted(reported, origin); }, *found);
  }

  std::optional<ValueResult> quoted(const std::string& reported, const std::string& origin) {
    return text(reported, origin);
  }
  std::optional<ValueResult> quoted(const std::vector<double>& reported, const std::string&) {
    return vector(reported.size(), "report the one that the text speaks of by a name of its own");
  }
  template <typename Reported>
  std::optional<ValueResult> quoted(Reported reported, const std::string& origin) {
    return number(Number(reported), origin);
  }

  std::optional<ValueResult> number(const Number& number, const std::string& origin) {
    const std::string& format = value_.format.text;
    if (format == "d" && !number.is_whole) {
      const bool large = number.value == std::floor(number.value);
      return error("E-value-format", value_.format,
                   "`:d` prints whole numbers" + std::string(large ? " below 2^53" : "") +
                       ", and this is " + number_in_text(number, ""),
                   "round it by hand, or use `:.0f`");
    }
    return ValueResult{number_in_text(number, format), origin};
  }
  std::optional<ValueResult> text(const std::string& words, const std::string& origin) {
    if (value_.format.text.empty()) return ValueResult{words, origin};
    return error("E-value-format", value_.format, "this is a text, which takes no format", "");
  }
  std::optional<ValueResult> vector(std::size_t numbers, const std::string& cure) {
    return error("E-value-kind", value_.expression,
                 "this is a vector of " + std::to_string(numbers) + " numbers; the text takes one",
                 cure);
  }

  std::nullopt_t error(const std::string& id, const LocatedText& at, const std::string& message,
                       const std::string& cure) {
    diagnostics_.push_back(error_at(place_of(*lesson_.source, at.span()), id, message, cure));
    return std::nullopt;
  }

  const InlineValue& value_;
  const Lesson& lesson_;
  WorkerContext& worker_context_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<ValueResult> evaluate_value(const InlineValue& value, const Lesson& lesson,
                                          WorkerContext& worker_context, Diagnostics& diagnostics) {
  return Quotation(value, lesson, worker_context, diagnostics).run();
}

}  // namespace mjcourse
