#include "cli/command_line.h"

#include <unistd.h>

#include <algorithm>

#include "base/nearest.h"
#include "process/our_command.h"
#include "report/terminal_style.h"
#include "report/wrapped.h"

namespace mjcourse {
namespace {

constexpr std::size_t kOptionIndent = 17;

}  // namespace

void CommandLine::flag(std::string name, std::string help, bool& on) {
  value(std::move(name), {}, std::move(help), [&on](const std::string&) { return on = true; });
}

void CommandLine::path(const std::string& name, const ValueKind& kind, std::string help,
                       std::filesystem::path& to) {
  // An address that became a folder would be told of with its password.
  const auto take = [&to, name, kind](const std::string& value) {
    if (value.find("://") != value.npos) {
      throw WrongUsage(name + " takes " + kind.called + ", not an address" +
                       (name == "--store" ? "; --store-url takes one" : ""));
    }
    to = value;
    return true;
  };
  value(name, kind, std::move(help), take);
}

void CommandLine::value(std::string name, ValueKind kind, std::string help,
                        std::function<bool(const std::string&)> take,
                        std::vector<std::string> known) {
  options_.push_back(
      {std::move(name), std::move(kind), std::move(help), std::move(take), std::move(known)});
}

void CommandLine::words(std::string form, std::string help, std::vector<std::string>& to) {
  form_ = std::move(form);
  words_help_ = std::move(help);
  words_ = &to;
}

bool CommandLine::has(const std::string& option) const {
  return std::any_of(options_.begin(), options_.end(),
                     [&](const Option& known) { return known.name == option; });
}

const CommandLine::Option& CommandLine::option_called(const std::string& name) const {
  std::vector<std::string> known;
  for (const Option& option : options_) {
    if (option.name == name) return option;
    known.push_back(option.name);
  }
  throw UnknownOption(name, command_ + " has no option " + name + "; " + suggest(name, known));
}

void CommandLine::take_value(const Option& option, const std::string& value) {
  const std::string& kind = option.kind.called;
  // An unset variable in somebody's script, not a wish for what is usual.
  if (value.empty()) throw WrongUsage(option.name + " needs " + kind + ", not \"\"");
  if (option.take(value)) return;
  const bool is_near = !nearest(value, option.known).empty();
  throw WrongUsage(option.name + " takes " + kind + ", not " + value +
                   (is_near ? "; " + suggest(value, option.known) : ""));
}

void CommandLine::take_word(const std::string& word) const {
  const std::string shown = word.empty() ? "\"\"" : word;
  if (words_ == nullptr) throw WrongUsage(command_ + " takes only options, not " + shown);
  if (word.empty()) throw WrongUsage(command_ + " takes " + form_ + ", not " + shown);
  words_->push_back(word);
}

// A shell that writes out `*` does not ask how the names begin.
bool CommandLine::names_a_file(const std::string& argument) const {
  std::error_code none;
  const std::string name = argument.substr(0, argument.find('='));
  return words_ != nullptr && argument.size() > 2 && !has(name) && name != "--help" &&
         std::filesystem::exists(argument, none);
}

bool CommandLine::read(const std::vector<std::string>& arguments) {
  bool in_options = true;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (!in_options || !argument.starts_with('-') || names_a_file(argument)) {
      take_word(argument);
      continue;
    }
    in_options = argument != "--";
    if (!in_options) continue;
    if (argument == "--help" || argument == "-h") return false;
    // `--format=json` is `--format json`.
    const std::size_t equals = std::min(argument.find('='), argument.size());
    const bool joined = equals < argument.size();
    const Option& option = option_called(argument.substr(0, equals));
    const std::string& kind = option.kind.called;
    if (kind.empty()) {
      if (joined) throw WrongUsage(option.name + " takes no value");
      option.take("");
      continue;
    }
    const bool is_last = i + 1 == arguments.size();
    if (!joined && (is_last || has(arguments[i + 1]))) {
      throw WrongUsage(option.name + " needs " + kind);
    }
    take_value(option, joined ? argument.substr(equals + 1) : arguments[++i]);
  }
  return true;
}

std::string CommandLine::help(const std::string& summary) const {
  std::string text = "usage: " + called_as() + " " + command_ + " [OPTIONS] " + form_;
  text.erase(text.find_last_not_of(' ') + 1);
  text += "\n\n" + wrapped(summary, style_for(STDOUT_FILENO).width, 0) + "\n\n";
  if (words_ != nullptr) text += help_line(form_, words_help_, kOptionIndent);
  for (const Option& option : options_) {
    const std::string space = option.kind.shown.empty() ? "" : " ";
    text += help_line(option.name + space + option.kind.shown, option.help, kOptionIndent);
  }
  return text;
}

std::string help_line(const std::string& name, const std::string& what, std::size_t indent) {
  std::string line = "  " + name;
  line += line.size() < indent ? std::string(indent - line.size(), ' ')
                               : "\n" + std::string(indent, ' ');
  const auto at = static_cast<int>(indent);
  return line + wrapped(what, style_for(STDOUT_FILENO).width, at, at) + "\n";
}

}  // namespace mjcourse
