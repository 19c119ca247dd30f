#include "evaluate/programs/records.h"

#include <re2/re2.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "base/utf8.h"

namespace mjcourse {
namespace {

using nlohmann::json;

constexpr std::size_t kMostRecordCount = 10'000, kMostFaults = 100;

// Thrown and caught in here: what is wrong with the value of one record.
class Unfit : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

double number_of(const json& value) {
  if (!value.is_number()) throw Unfit("holds what is not a finite number");
  return value.get<double>();
}

std::vector<double> numbers_of(const json& value) {
  if (!value.is_array()) throw Unfit("holds what is not a list of numbers");
  std::vector<double> numbers;
  for (const json& number : value) numbers.push_back(number_of(number));
  return numbers;
}

Reported reported_of(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return numbers_of(value);
  const double number = number_of(value);
  if (std::abs(number) < 0x1p53) return number;
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  return value.is_number_integer() ? Reported(value.get<std::int64_t>()) : Reported(number);
}

Table table_of(const json& value) {
  Table columns;
  std::set<std::string> names;
  for (const json& column : value) {
    if (!column.is_array() || column.size() != 2 || !column[0].is_string()) {
      throw Unfit("has a column that is not a name with a list of numbers");
    }
    columns.push_back({column[0].get<std::string>(), numbers_of(column[1])});
    const auto& [name, values] = columns.back();
    if (!names.insert(name).second) throw Unfit("has two columns \"" + name + "\"");
    const auto& [first, as_long] = columns.front();
    if (values.size() != as_long.size()) {
      throw Unfit("has columns of different lengths: " + std::to_string(as_long.size()) + " in \"" +
                  first + "\", " + std::to_string(values.size()) + " in \"" + name + "\"");
    }
  }
  if (columns.empty()) throw Unfit("has no columns");
  return columns;
}

State snapshot_of(const json& value) {
  if (!value.is_object()) throw Unfit("is not an object of fields");
  State state;
  for (const auto& [field, numbers] : value.items()) {
    state[field] = numbers.is_array() ? numbers_of(numbers) : std::vector{number_of(numbers)};
  }
  return state;
}

// What a message quotes of a program's words.
std::string beginning(const std::string& text) {
  constexpr std::size_t most = 60;
  if (text.size() <= most) return text;
  return text.substr(0, character_start(text, most)) + "…";
}

// Throws Unfit, or what the library throws at a value that is of another type.
Check check_of(const std::string& what, const json& value) {
  return {what,
          value.at("holds").get<bool>(),
          value.at("meaning").get<std::string>(),
          value.at("found").get<std::string>(),
          number_of(value.at("points")),
          value.at("line").get<int>()};
}

class Reader {
 public:
  explicit Reader(std::vector<RecordFault>& faults) : faults_(faults) {}

  void read(const std::string& line) {
    const json record = json::parse(line, nullptr, false);
    const bool known = add("result", record, reported_of, records_.results) ||
                       add("table", record, table_of, records_.tables) ||
                       add("snapshot", record, snapshot_of, records_.snapshots) ||
                       add_check(record);
    if (known) return;
    faults_.push_back({"", "what the program reported cannot be read: `" + beginning(line) + "`",
                       "report UTF-8, and from one thread at a time"});
  }

  Records take() { return std::move(records_); }

 private:
  // False when `record` is none of this kind.
  template <typename Read, typename Value>
  bool add(const std::string& kind, const json& record, const Read& read,
           std::map<std::string, Value>& into) {
    if (!record.is_object() || !record.contains("value")) return false;
    const auto named = record.find(kind);
    if (named == record.end() || !named->is_string()) return false;
    const auto& name = named->get_ref<const std::string&>();
    const std::string what = "the " + kind + " \"" + beginning(name) + "\"";
    static const RE2 form("[A-Za-z_][A-Za-z0-9_]*");
    if (!RE2::FullMatch(name, form)) {
      faults_.push_back({name, what + " has a name that no lesson can write",
                         "use letters, digits and `_`, as `largest_error`"});
    } else if (into.contains(name)) {
      faults_.push_back({name, what + " is reported twice", "give each a name of its own"});
    } else {
      try {
        into[name] = read(record["value"]);
      } catch (const Unfit& unfit) {
        into.erase(name);
        const std::string message = what + " " + unfit.what();
        faults_.push_back({name, message, "look for how it came about, and report what is sound"});
      }
    }
    return true;
  }

  // Of several of one name, the first that failed counts.
  bool add_check(const json& record) {
    if (!record.is_object() || !record.contains("check") || !record.contains("value")) return false;
    try {
      Check check = check_of(record["check"].get<std::string>(), record["value"]);
      if (check.points < 0) {
        faults_.push_back({check.what,
                           "the check \"" + beginning(check.what) + "\" has fewer than 0 points",
                           "give 0 or more"});
        return true;
      }
      const auto known = std::ranges::find(records_.checks, check.what, &Check::what);
      if (known == records_.checks.end()) {
        records_.checks.push_back(std::move(check));
      } else if (known->holds) {
        *known = std::move(check);
      }
      return true;
    } catch (const json::exception&) {
    } catch (const Unfit&) {
    }
    return false;
  }

  std::vector<RecordFault>& faults_;
  Records records_;
};

}  // namespace

Records read_records(const std::string& lines, std::vector<RecordFault>& faults) {
  Reader reader(faults);
  std::istringstream text(lines);
  std::size_t count = 0;
  for (std::string line; std::getline(text, line);) {
    if (++count > kMostRecordCount) {
      faults.push_back({"", "the program reported more than 10000 records",
                        "report lists as one record: `table`, or a list as a `result`"});
      break;
    }
    reader.read(line);
    if (faults.size() < kMostFaults) continue;
    faults.push_back({"", "a hundred records are wrong; those after them were not read",
                      "fix the first ones: others often follow from them"});
    break;
  }
  return reader.take();
}

}  // namespace mjcourse
