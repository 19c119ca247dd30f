#include "evaluate/inline_value.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/nearest.h"
#include "evaluate/script_place.h"
#include "script/world.h"

namespace mjcourse {
namespace {

bool is_whole(double x) {
  return x == std::floor(x) && std::abs(x) < 0x1p53;  // above, not every whole number is a double
}

// `x` as printf prints it: a whole number plainly and another with six digits, unless `format` asks
// for something else.
std::string number_in_text(double x, const std::string& format) {
  std::string form = is_whole(x) ? "%.0f" : "%.6g";
  if (!format.empty()) form = format == "d" ? "%.0f" : "%" + format;
  const int size = std::snprintf(nullptr, 0, form.c_str(), x);
  std::string text(static_cast<std::size_t>(size) + 1, '\0');
  std::snprintf(text.data(), text.size(), form.c_str(), x);
  text.pop_back();
  const bool nothing = text.substr(0, text.find('e')).find_first_of("123456789") == text.npos;
  return nothing && text.starts_with('-') ? text.substr(1) : text;
}

class Quotation {
 public:
  Quotation(const InlineValue& value, const Lesson& lesson, Workshop& workshop,
            Diagnostics& diagnostics)
      : value_(value), lesson_(lesson), workshop_(workshop), diagnostics_(diagnostics) {}

  std::optional<ValueResult> run() {
    const std::string& name = value_.source.text;
    std::vector<std::string> known = workshop_.course().models;
    const bool model = std::find(known.begin(), known.end(), name) != known.end();
    const std::vector<std::string> examples = workshop_.reports_of(name).examples();
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
    auto simulation = workshop_.simulate(value_.source, *lesson_.source, diagnostics_);
    if (!simulation) return std::nullopt;
    World world(workshop_.world_bundle(), *simulation);
    const auto found = world.value(value_.expression.text);
    if (!found) {
      diagnostics_.push_back(script_diagnostic(found.error(), value_.expression, *lesson_.source));
      return std::nullopt;
    }
    const std::string origin = value_.expression.text + " of " + value_.source.text + ".xml";
    const nlohmann::json& json = *found;
    if (json.is_string()) return text(json.get<std::string>(), origin);
    if (json.is_array() && json.size() == 1 && json[0].is_number()) return number(json[0], origin);
    if (json.is_number()) return number(json, origin);
    return json.is_array() ? vector(json.size(), "choose one of them, as `qpos('hinge')[0]`")
                           : error("E-value-kind", value_.expression,
                                   "this is true or false; the text takes a number", "");
  }

  std::optional<ValueResult> of_example() {
    const auto found = workshop_.reports_of(value_.source.text)
                           .find(value_.source, value_.expression, *lesson_.source, diagnostics_);
    if (!found) return std::nullopt;
    const std::string origin = value_.expression.text + " of " + value_.source.text + ".cpp";
    if (const auto* x = std::get_if<double>(&*found)) return number(*x, origin);
    if (const auto* words = std::get_if<std::string>(&*found)) return text(*words, origin);
    return vector(std::get<std::vector<double>>(*found).size(),
                  "report the one that the text speaks of by a name of its own");
  }

  std::optional<ValueResult> number(double x, const std::string& origin) {
    const std::string& format = value_.format.text;
    if (format == "d" && !is_whole(x)) {
      return error("E-value-format", value_.format,
                   "`:d` prints whole numbers" +
                       std::string(x == std::floor(x) ? " below 2^53" : "") + ", and this is " +
                       number_in_text(x, ""),
                   "round it by hand, or use `:.0f`");
    }
    return ValueResult{number_in_text(x, format), origin};
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
  Workshop& workshop_;
  Diagnostics& diagnostics_;
};

}  // namespace

std::optional<ValueResult> evaluate_value(const InlineValue& value, const Lesson& lesson,
                                          Workshop& workshop, Diagnostics& diagnostics) {
  return Quotation(value, lesson, workshop, diagnostics).run();
}

}  // namespace mjcourse
