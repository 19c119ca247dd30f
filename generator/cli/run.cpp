#include "cli/run.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string_view>

#include "base/nearest.h"
#include "cli/commands.h"

namespace mjcourse {
namespace {

struct Option {
  std::string_view name;
  std::string_view value;  // what must follow it: "a folder"; empty where nothing may
  void (*take)(Options&, const std::string& value);
};

constexpr Option kCourse{"--course", "a folder", [](Options& options, const std::string& value) {
                           options.course = value;
                         }};
constexpr Option kOut{"--out", "a folder",
                      [](Options& options, const std::string& value) { options.out = value; }};

constexpr Option kDryRun{"--dry-run", "",
                         [](Options& options, const std::string&) { options.dry_run = true; }};

constexpr Option kReport{"--report", "a folder", [](Options& options, const std::string& value) {
                           options.report = value;
                         }};
constexpr Option kStrict{"--strict", "",
                         [](Options& options, const std::string&) { options.strict = true; }};

struct Named {
  std::string_view name;
  int (*command)(const Options&);
  std::vector<Option> options;
  bool takes_places = false;  // words that are no options
};

const std::vector<Named>& commands() {
  static const std::vector<Named> all{{"accept", accept, {kCourse, kDryRun}, true},
                                      {"build", build, {kCourse, kOut, kReport}},
                                      {"check", check, {kCourse, kReport, kStrict}}};
  return all;
}

constexpr std::string_view kHelp =
    "usage: mjcourse COMMAND [OPTIONS]\n"
    "\n"
    "  build              evaluate the course and write its site\n"
    "  check              evaluate the course and write nothing\n"
    "  accept [WHERE...]  evaluate the course, show where it differs from what is committed, and\n"
    "                     write what was computed: outputs, programs, regions, pictures\n"
    "\n"
    "  WHERE          a lesson (1.2, its slug or its path), or the block at one of its lines\n"
    "                 (1.2:210); none means all\n"
    "  --course DIR   the course: a folder with content/, models/ and examples/ (default: .)\n"
    "  --out DIR      where build puts the site (default: build/site in the course)\n"
    "  --report DIR   write what was verified, and how, to DIR/index.html and verification.json\n"
    "  --strict       check: no warnings, and a reason for all that was not proved\n"
    "  --dry-run      accept shows the differences and writes nothing; the exit code is 1 if "
    "there\n"
    "                 are any\n"
    "\n"
    "Exit code: 0 clean, 1 the course has errors (after accept: those that it cannot mend),\n"
    "2 wrong usage, 3 our fault.\n";

int wrong_usage(const std::string& message) {
  std::cerr << "mjcourse: " << message << "\n`mjcourse --help` shows the commands\n";
  return kWrongUsage;
}

std::string no_option(const Named& named, const std::string& argument) {
  std::vector<std::string> known;
  for (const Option& option : named.options) known.emplace_back(option.name);
  return std::string(named.name) + " has no option " + argument + "; " + suggest(argument, known);
}

int run_named(const Named& named, const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--help") {
      std::cout << kHelp;
      return kClean;
    }
    const auto option = std::find_if(named.options.begin(), named.options.end(),
                                     [&](const Option& known) { return known.name == argument; });
    if (option == named.options.end() && named.takes_places && !argument.starts_with('-')) {
      options.where.push_back(argument);
      continue;
    }
    if (option == named.options.end()) return wrong_usage(no_option(named, argument));
    const bool needs_value = !option->value.empty();
    if (needs_value && i + 1 == arguments.size()) {
      return wrong_usage(argument + " needs " + std::string(option->value));
    }
    option->take(options, needs_value ? arguments[++i] : "");
  }
  if (options.out.empty()) options.out = options.course / "build" / "site";
  options.course = std::filesystem::absolute(options.course);  // tools run in folders of their own
  return named.command(options);
}

}  // namespace

int run_command(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return wrong_usage("which command?");
  if (arguments[0] == "--help" || arguments[0] == "help") {
    std::cout << kHelp;
    return kClean;
  }
  if (arguments[0] == "--version") {
    std::cout << "mjcourse " MJCOURSE_VERSION "\n";
    return kClean;
  }
  try {
    std::vector<std::string> names;
    for (const Named& named : commands()) {
      if (arguments[0] == named.name) return run_named(named, arguments);
      names.emplace_back(named.name);
    }
    return wrong_usage("there is no command " + arguments[0] + "; " + suggest(arguments[0], names));
  } catch (const std::exception& error) {
    std::cerr << "mjcourse: " << error.what() << '\n';
    return kOurFault;
  }
}

}  // namespace mjcourse
