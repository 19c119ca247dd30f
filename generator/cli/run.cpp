#include "cli/run.h"

#include <algorithm>
#include <exception>
#include <iostream>
#include <string_view>

#include "base/nearest.h"
#include "cli/commands.h"

namespace mjcourse {
namespace {

struct Named {
  std::string_view name;
  int (*command)(const Options&);
  std::vector<std::string> options;
};

const Named kCommands[] = {{"build", build, {"--course", "--out", "--report"}},
                           {"check", check, {"--course", "--report", "--strict"}}};

constexpr std::string_view kHelp =
    "usage: mjcourse COMMAND [OPTIONS]\n"
    "\n"
    "  build   evaluate the course and write its site\n"
    "  check   evaluate the course and write nothing\n"
    "\n"
    "  --course DIR   the course: a folder with content/, models/ and examples/ (default: .)\n"
    "  --out DIR      where build puts the site (default: build/site in the course)\n"
    "  --report DIR   write what was verified, and how, to DIR/index.html and verification.json\n"
    "  --strict       check: no warnings, and a reason for all that was not proved\n"
    "\n"
    "Exit code: 0 clean, 1 the course has errors, 2 wrong usage, 3 our fault.\n";

int wrong_usage(const std::string& message) {
  std::cerr << "mjcourse: " << message << "\n`mjcourse --help` shows the commands\n";
  return kWrongUsage;
}

int run_named(const Named& named, const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    if (argument == "--help") {
      std::cout << kHelp;
      return kClean;
    }
    if (std::find(named.options.begin(), named.options.end(), argument) == named.options.end()) {
      return wrong_usage(std::string(named.name) + " has no option " + argument + "; " +
                         suggest(argument, named.options));
    }
    if (argument == "--strict") {
      options.strict = true;
      continue;
    }
    if (i + 1 == arguments.size()) return wrong_usage(argument + " needs a folder");
    (argument == "--out"      ? options.out
     : argument == "--report" ? options.report
                              : options.course) = arguments[++i];
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
    for (const Named& named : kCommands) {
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
