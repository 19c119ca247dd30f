#include "cli/tally_text.h"

#include <vector>

#include "base/counted.h"

namespace mjcourse {
namespace {

// "3 programs run", "1 lab rehearsed"; "" for none.
void add_count(std::vector<std::string>& parts, int count, const char* one, const char* many) {
  if (count > 0) parts.push_back(counted(count, one, many));
}

}  // namespace

std::string tally_text(const Tally& tally) {
  std::vector<std::string> parts;
  add_count(parts, tally.programs, "program run", "programs run");
  add_count(parts, tally.snippets, "snippet run", "snippets run");
  // Of both.
  if (tally.in_page > 0) parts.push_back(std::to_string(tally.in_page) + " in the page");
  add_count(parts, tally.exercises, "exercise tried", "exercises tried");
  add_count(parts, tally.commands, "listing of commands run", "listings of commands run");
  add_count(parts, tally.outputs, "output compared", "outputs compared");
  add_count(parts, tally.values, "value computed", "values computed");
  add_count(parts, tally.listed_models, "model listing checked", "model listings checked");
  add_count(parts, tally.answers_proved, "answer proved", "answers proved");
  add_count(parts, tally.answers_asserted, "answer asserted", "answers asserted");
  add_count(parts, tally.labs, "lab rehearsed", "labs rehearsed");
  add_count(parts, tally.pictures, "picture drawn", "pictures drawn");
  add_count(parts, tally.plots, "plot drawn", "plots drawn");
  add_count(parts, tally.formulas, "formula set", "formulas set");
  add_count(parts, tally.unchecked, "listing unchecked", "listings unchecked");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string outcome_text(const Tally& tally, std::ptrdiff_t errors) {
  std::string text = tally_text(tally);
  if (!text.empty()) return text;
  return errors > 0 ? "nothing verified" : "nothing to verify";
}

}  // namespace mjcourse
