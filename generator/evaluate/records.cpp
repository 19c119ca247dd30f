#include "evaluate/records.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace mjcourse {
namespace {

using nlohmann::json;

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
  std::vector<double> numbers;
  for (const json& number : value) numbers.push_back(number_of(number));
  return numbers;
}

Reported reported_of(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return numbers_of(value);
  return number_of(value);
}

Table table_of(const json& value) {
  Table columns;
  std::set<std::string> names;
  for (const json& column : value) {
    columns.push_back({column.at(0).get<std::string>(), numbers_of(column.at(1))});
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
  State state;
  for (const auto& [field, numbers] : value.items()) {
    state[field] = numbers.is_array() ? numbers_of(numbers) : std::vector{number_of(numbers)};
  }
  return state;
}

class Reader {
 public:
  explicit Reader(std::vector<RecordFault>& faults) : faults_(faults) {}

  void read(const std::string& line) {
    const json record = json::parse(line, nullptr, false);
    if (record.is_object() && record.contains("value")) {
      if (const auto kind = record.find("result"); kind != record.end()) {
        return add("result", *kind, record["value"], reported_of, records_.results);
      }
      if (const auto kind = record.find("table"); kind != record.end()) {
        return add("table", *kind, record["value"], table_of, records_.tables);
      }
      if (const auto kind = record.find("snapshot"); kind != record.end()) {
        return add("snapshot", *kind, record["value"], snapshot_of, records_.snapshots);
      }
    }
    faults_.push_back({"", "what the program reported cannot be read: `" + line.substr(0, 60) + "`",
                       "report UTF-8, and from one thread at a time"});
  }

  Records take() { return std::move(records_); }

 private:
  template <typename Read, typename Value>
  void add(const std::string& kind, const std::string& name, const json& value, const Read& read,
           std::map<std::string, Value>& into) {
    static const std::regex form("[A-Za-z_][A-Za-z0-9_]*");
    const std::string what = "the " + kind + " \"" + name + "\"";
    if (!std::regex_match(name, form)) {
      faults_.push_back({name, what + " has a name that no lesson can write",
                         "use letters, digits and `_`, as `largest_error`"});
    } else if (into.contains(name)) {
      faults_.push_back({name, what + " is reported twice", "give each a name of its own"});
    } else {
      try {
        into[name] = read(value);
      } catch (const Unfit& unfit) {
        into.erase(name);
        const std::string message = what + " " + unfit.what();
        faults_.push_back({name, message, "look for how it came about, and report what is sound"});
      }
    }
  }

  std::vector<RecordFault>& faults_;
  Records records_;
};

}  // namespace

Records read_records(const std::string& lines, std::vector<RecordFault>& faults) {
  Reader reader(faults);
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) reader.read(line);
  return reader.take();
}

}  // namespace mjcourse
