#include "cli/run.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <iostream>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/cache_folder.h"
#include "base/nearest.h"
#include "base/our_command.h"
#include "cli/commands.h"
#include "cli/log_guard.h"
#include "cli/out_place.h"
#include "cli/size.h"
#include "course/web_address.h"
#include "evaluate/work_loop.h"
#include "evaluate/worker.h"
#include "page/course_data.h"
#include "page/foreign_files.h"
#include "physics/mesa.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostJobs = 1024;

struct CommandOption {
  std::string_view name;
  std::string_view value;  // what must follow it: "a folder"; empty where nothing may
  bool (*take)(Options&, const std::string& value);  // false where the value is no such thing
};

constexpr CommandOption kCourse{"--course", "a folder",
                                [](Options& options, const std::string& value) {
                                  options.course = value;
                                  options.course_named = true;
                                  return true;
                                }};
constexpr CommandOption kOut{"--out", "a folder", [](Options& options, const std::string& value) {
                               options.out = value;
                               return true;
                             }};

constexpr CommandOption kBaseUrl{"--base-url",
                                 "the address of a site, as https://example.org/course/",
                                 [](Options& options, const std::string& value) {
                                   options.base_url = site_root(value);
                                   return !site_address_fault(value);
                                 }};
constexpr CommandOption kDryRun{"--dry-run", "", [](Options& options, const std::string&) {
                                  options.dry_run = true;
                                  return true;
                                }};

constexpr CommandOption kReport{"--report", "a folder",
                                [](Options& options, const std::string& value) {
                                  options.report = value;
                                  return true;
                                }};
constexpr CommandOption kCompress{"--compress", "", [](Options& options, const std::string&) {
                                    options.compress = true;
                                    return true;
                                  }};
constexpr CommandOption kStrict{"--strict", "", [](Options& options, const std::string&) {
                                  options.strict = true;
                                  return true;
                                }};

constexpr CommandOption kFormat{
    "--format", "text, json, github, sarif or junit",
    [](Options& options, const std::string& value) {
      constexpr std::array<std::pair<std::string_view, Format>, 5> known{
          {{"text", Format::text},
           {"json", Format::json},
           {"github", Format::github},
           {"sarif", Format::sarif},
           {"junit", Format::junit}}};
      const auto named = std::find_if(known.begin(), known.end(),
                                      [&](const auto& one) { return one.first == value; });
      if (named == known.end()) return false;
      options.format = named->second;
      return true;
    }};

constexpr CommandOption kStore{"--store", "a folder",
                               [](Options& options, const std::string& value) {
                                 options.store = value;
                                 return true;
                               }};
constexpr CommandOption kJobs{
    "--jobs", "a number of threads", [](Options& options, const std::string& value) {
      const char* end = value.data() + value.size();
      const auto read = std::from_chars(value.data(), end, options.jobs);
      return read.ptr == end && options.jobs > 0 && options.jobs <= kMostJobs;
    }};
constexpr CommandOption kTimings{"--timings", "", [](Options& options, const std::string&) {
                                   options.timings = true;
                                   return true;
                                 }};
constexpr CommandOption kTrace{"--trace", "a file", [](Options& options, const std::string& value) {
                                 options.trace = value;
                                 return true;
                               }};
constexpr CommandOption kKeep{"--keep", "a size, as 2GB",
                              [](Options& options, const std::string& value) {
                                const auto bytes = read_size(value);
                                options.keep = bytes.value_or(0);
                                return bytes.has_value();
                              }};

constexpr int kLastPort = 65535;
constexpr CommandOption kPort{"--port", "a port from 1 to 65535",
                              [](Options& options, const std::string& value) {
                                int port = 0;
                                const char* end = value.data() + value.size();
                                const auto read = std::from_chars(value.data(), end, port);
                                options.port = port;
                                return read.ptr == end && port > 0 && port <= kLastPort;
                              }};
constexpr CommandOption kOpen{"--open", "", [](Options& options, const std::string&) {
                                options.open = true;
                                return true;
                              }};
constexpr CommandOption kLink{"--link", "an address with {file} in it",
                              [](Options& options, const std::string& value) {
                                options.link = value;
                                return value.find("{file}") != value.npos;
                              }};

constexpr CommandOption kWithoutLandlock{"--unsafe-without-landlock", "",
                                         [](Options& options, const std::string&) {
                                           options.without_landlock = true;
                                           return true;
                                         }};

struct NamedCommand {
  std::string_view name;
  int (*command)(const Options&);
  std::vector<CommandOption> options;
  bool takes_words = false;  // that are no options
};

const std::vector<NamedCommand>& commands() {
  static const std::vector<NamedCommand> all{
      {"accept", accept, {kCourse, kDryRun, kStore, kJobs, kWithoutLandlock}, true},
      {"build",
       build,
       {kCourse, kOut, kBaseUrl, kCompress, kReport, kStore, kJobs, kTimings, kTrace,
        kWithoutLandlock}},
      {"check",
       check,
       {kCourse, kReport, kStrict, kFormat, kStore, kJobs, kTimings, kTrace, kWithoutLandlock}},
      {"doctor", doctor, {kStore}},
      {"explain", explain, {kCourse, kStore}, true},
      {"init", init, {}, true},
      {"list", list, {kCourse, kStore, kJobs}},
      {"lsp", lsp, {kCourse, kStore, kJobs, kWithoutLandlock}},
      {"new", make_new, {kCourse}, true},
      {"preview", preview, {kCourse, kPort, kOpen, kLink, kStore, kJobs, kWithoutLandlock}},
      {"store", store, {kStore, kKeep}, true}};
  return all;
}

constexpr std::string_view kHelp =
    " COMMAND [OPTIONS]\n"
    "\n"
    "  build              evaluate the course and write its site\n"
    "  preview            show the course in a browser while it is being written\n"
    "  lsp                answer an editor: mistakes, completion and more while you write\n"
    "  check              evaluate the course and write nothing\n"
    "  accept [WHERE...]  evaluate the course, show where it differs from what is committed, and\n"
    "                     write what was computed: outputs, programs, regions, pictures\n"
    "  explain [WHERE...] what each block depends on, and whether its result would be used again\n"
    "  explain ID         what a message means and how it is cured, by its name: E-output-differs\n"
    "  list               the lessons, and how each of them stands\n"
    "  new KIND NAME      begin a level, a lesson, a model or an example of the course\n"
    "  init DIR [TITLE]   begin a course in a new folder\n"
    "  doctor             try out what this machine has of all that courses need\n"
    "  store prune        forget the results that were not used for longest\n"
    "  --version          which version this is\n"
    "\n"
    "  WHERE          a lesson (1.2, its slug or its path), or the block at one of its lines\n"
    "                 (1.2:210); none means all\n"
    "  NAME           of a level or a lesson, then its title: new level 2-dynamics \"Dynamics\",\n"
    "                 new lesson 2-dynamics \"Forces\"; of a model: new model pendulum; of an\n"
    "                 example, then its model: new example l2_1_forces pendulum\n"
    "  --course DIR   the course: a folder with content/, models/ and examples/ (default: .; of\n"
    "                 lsp, the folder that is open in the editor)\n"
    "  --out DIR      where build puts the site (default: build/site in the course)\n"
    "  --base-url URL build: where the site is published, whatever course.yaml says\n"
    "  --compress     build: each file of text also as NAME.br and NAME.gz, for servers that send "
    "these\n"
    "  --report DIR   write what was verified, and how, to DIR/index.html and verification.json\n"
    "  --strict       check: no warnings, and a reason for all that was not proved\n"
    "  --format NAME  check: say it to another tool on stdout, and to you on stderr: json, "
    "github,\n"
    "                 sarif or junit (default: text)\n"
    "  --dry-run      accept shows the differences and writes nothing; the exit code is 1 if "
    "there\n"
    "                 are any\n"
    "  --store DIR    where results are kept (default: the user's cache)\n"
    "  --jobs N       how many threads work (default: one for each core)\n"
    "  --timings      build, check: print what took longest\n"
    "  --trace FILE   build, check: write when everything was worked on, for a browser's trace\n"
    "                 viewer\n"
    "  --port N       where preview answers (default: the first that is free from 8000 on)\n"
    "  --open         preview opens a browser\n"
    "  --link FORM    how a previewed page opens your editor, with {file}, {line}, {column}\n"
    "                 (default: vscode://file{file}:{line}:{column})\n"
    "  --unsafe-without-landlock\n"
    "                 run a course's programs where the kernel has no Landlock to keep them from\n"
    "                 your files: for courses whose every program you trust\n"
    "  --keep SIZE    how much store prune leaves, as 500MB (default: 2GB)\n"
    "\n"
    "Exit code: 0 clean, 1 the course has errors (after accept: those that it cannot mend),\n"
    "2 wrong usage, 3 our fault.\n";

int wrong_usage(const std::string& message) {
  std::cerr << "mjcourse: " << message << "\n" << our_command("--help") << " shows the commands\n";
  return kWrongUsage;
}

std::string no_option(const NamedCommand& named, const std::string& argument) {
  std::vector<std::string> known;
  for (const CommandOption& option : named.options) known.emplace_back(option.name);
  return std::string(named.name) + " has no option " + argument + "; " + suggest(argument, known);
}

// Absolute and without `.`, as the paths are that are compared with it; tools run in folders of
// their own.
std::filesystem::path whole_path(const std::filesystem::path& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

int run_named(const NamedCommand& named, const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    // `--format=json` is `--format json`.
    const std::size_t equals = arguments[i].find('=');
    const bool joined = arguments[i].starts_with("--") && equals != std::string::npos;
    const std::string argument = joined ? arguments[i].substr(0, equals) : arguments[i];
    if (argument == "--help") {
      std::cout << "usage: " << called_as() << kHelp;
      return kClean;
    }
    const auto option =
        std::find_if(named.options.begin(), named.options.end(),
                     [&](const CommandOption& known) { return known.name == argument; });
    if (option == named.options.end() && named.takes_words && !argument.starts_with('-')) {
      options.where.push_back(argument);
      continue;
    }
    if (option == named.options.end()) return wrong_usage(no_option(named, argument));
    const bool needs_value = !option->value.empty();
    if (joined && !needs_value) return wrong_usage(argument + " takes no value");
    if (needs_value && !joined && i + 1 == arguments.size()) {
      return wrong_usage(argument + " needs " + std::string(option->value));
    }
    const std::string value = joined        ? arguments[i].substr(equals + 1)
                              : needs_value ? arguments[++i]
                                            : "";
    // An unset variable in somebody's script, and not a wish for what is usual.
    if (needs_value && value.empty()) {
      return wrong_usage(argument + " needs " + std::string(option->value) + ", and has \"\"");
    }
    if (!option->take(options, value)) {
      return wrong_usage(argument + " takes " + std::string(option->value) + ", and not " + value);
    }
  }
  if (options.out.empty()) options.out = options.course / "build" / "site";
  options.course = whole_path(options.course);
  if (const auto refused = refused_out(options, named.name)) return tell(*refused);
  set_up_mesa(user_cache_folder());
  // What other programs read is whole as it is.
  const LogGuard guard(options.format == Format::text && named.command != lsp);
  return named.command(options);
}

}  // namespace

int run_command(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return wrong_usage("which command?");
  if (arguments[0] == "--help" || arguments[0] == "help") {
    std::cout << "usage: " << called_as() << kHelp;
    return kClean;
  }
  if (arguments[0] == "--version") {
    std::cout << "mjcourse " MJCOURSE_VERSION "\n";
    return kClean;
  }
  try {
    if (arguments[0] == kWorkCommand && arguments.size() == 3) {
      answer_questions(arguments[1], DiskFiles(arguments[2]));
      return kClean;
    }
    std::vector<std::string> names;
    for (const NamedCommand& named : commands()) {
      if (arguments[0] == named.name) return run_named(named, arguments);
      names.emplace_back(named.name);
    }
    return wrong_usage("there is no command " + arguments[0] + "; " + suggest(arguments[0], names));
  } catch (const FolderRefused& refused) {
    return tell(Refusal{kWrongUsage, refused.what(), refused.cure()});
  } catch (const LostFile& lost) {
    return tell(Refusal{kCourseErrors, lost.what(),
                        "it was there a moment ago: let it be read, and start again"});
  } catch (const std::system_error& error) {
    return tell(failed_call(error));
  } catch (const std::exception& error) {
    std::cerr << "mjcourse: " << error.what() << '\n';
    return kOurFault;
  }
}

}  // namespace mjcourse
