// The file into which a program reports to its lesson, of any bytes.
#include <cctype>
#include <cmath>

#include "base/utf8.h"
#include "evaluate/programs/records.h"
#include "fuzz.h"
#include "report/diagnostic.h"
#include "require.h"

namespace mjcourse {
namespace {

void check_name(const std::string& name) {
  require(!name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0,
          "a name: " + name);
  for (const char c : name)
    require(is_word_character(c), "a name that a lesson can write: " + name);
}

void check_numbers(const std::vector<double>& numbers) {
  for (const double number : numbers) require(std::isfinite(number), "numbers are finite");
}

void check_table(const Table& table) {
  require(!table.empty(), "a table has a column");
  for (const Column& column : table) {
    require(column.values.size() == table.front().values.size(), "columns are equally long");
    require(!find_invalid_utf8(column.name), "a column's name is UTF-8");
    check_numbers(column.values);
  }
}

void check_records(const std::string& lines) {
  std::vector<RecordFault> faults, again;
  const Records records = read_records(lines, faults);
  for (const auto& [name, value] : records.results) {
    check_name(name);
    if (const auto* text = std::get_if<std::string>(&value)) {
      require(!find_invalid_utf8(*text), "a result's text is UTF-8");
    }
    if (const auto* number = std::get_if<double>(&value)) check_numbers({*number});
    if (const auto* numbers = std::get_if<std::vector<double>>(&value)) check_numbers(*numbers);
  }
  for (const auto& [name, table] : records.tables) {
    check_name(name);
    check_table(table);
  }
  for (const auto& [name, state] : records.snapshots) {
    check_name(name);
    for (const auto& [field, numbers] : state) check_numbers(numbers);
  }
  for (const RecordFault& fault : faults) {
    const std::string said = error_at({}, "E-example-record", fault.message, fault.cure).message;
    require(said.size() < 3000, "what is wrong is said in few words");
    require(!find_invalid_utf8(fault.message) || find_invalid_utf8(lines),
            "what is wrong with UTF-8 is said in UTF-8: " + fault.message);
  }
  read_records(lines, again);
  require(faults.size() == again.size(), "a second reading finds as many faults");
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  mjcourse::check_records(mjcourse::text_of_input(data, size));
  return 0;
}
