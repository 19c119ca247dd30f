#include "cli/run.h"

#include <exception>
#include <functional>
#include <iostream>
#include <system_error>
#include <type_traits>
#include <utility>

#include "base/cache_folder.h"
#include "base/nearest.h"
#include "base/utf8.h"
#include "cli/command_line.h"
#include "cli/command_options.h"
#include "cli/commands.h"
#include "cli/log_guard.h"
#include "cli/out_place.h"
#include "evaluate/work_loop.h"
#include "evaluate/worker.h"
#include "page/course_data.h"
#include "page/foreign_files.h"
#include "page/template_process.h"
#include "process/mesa.h"
#include "process/our_command.h"
#include "remote/store_address.h"

namespace mjcourse {
namespace {

// Of the command line of `command`, where one is named.
int wrong_usage(const std::string& message, const std::string& command = "") {
  std::cerr << "mjcourse: " << without_userinfo(message) << '\n'
            << (command.empty() ? our_command("--help") + " shows the commands"
                                : our_command(command + " --help") + " shows what it takes")
            << '\n';
  return kWrongUsage;
}

// Absolute and without `.`, as the paths are that are compared with it; tools run in folders of
// their own.
std::filesystem::path whole_path(const std::filesystem::path& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

// Where a command of these options writes.
template <typename Options>
OutPlaces out_places(const Options& options) {
  OutPlaces places;
  if constexpr (requires { options.course; }) places.course = options.course;
  if constexpr (requires { options.out; }) places.site = options.out;
  if constexpr (requires { options.store; }) places.store = options.store;
  if constexpr (requires { options.report; }) places.report = options.report;
  if constexpr (requires { options.trace; }) places.trace = options.trace;
  if constexpr (requires { options.folder; }) places.exercise = options.folder;
  if constexpr (requires { options.results; }) places.exercise = options.results;
  return places;
}

// What other programs read is whole as it is.
template <typename Options>
bool people_read(const Options& options) {
  if constexpr (requires { options.format; })
    return options.format == decltype(options.format)::text;
  return !std::is_same_v<Options, LspOptions>;
}

template <typename Options>
int run_with(Options options, int (*command)(const Options&)) {
  if constexpr (requires { options.out; }) {
    if (options.out.empty()) options.out = options.course / "build" / "site";
  }
  if constexpr (requires { options.course; }) options.course = whole_path(options.course);
  const LogGuard guard(people_read(options));
  if (const auto refused = refused_out(out_places(options))) return tell(*refused);
  set_up_mesa(user_cache_folder());
  return command(options);
}

struct NamedCommand {
  std::string name, summary;
  CommandLine line;  // for what it takes; each run reads one of its own
  std::function<int(const std::vector<std::string>& arguments)> run;
};

const std::vector<NamedCommand>& commands();

// "build, check"
std::string names_of_those_with(const std::string& option) {
  std::string names;
  for (const NamedCommand& one : commands()) {
    if (one.line.has(option)) names += (names.empty() ? "" : ", ") + one.name;
  }
  return names;
}

template <typename Options>
CommandLine line_into(Options& options, const std::string& name) {
  CommandLine line(name);
  declare(line, options);
  return line;
}

template <typename Options>
int run_line(const std::string& name, const std::string& summary, int (*command)(const Options&),
             const std::vector<std::string>& arguments) {
  Options options;
  CommandLine line = line_into(options, name);
  try {
    if (line.read(arguments)) return run_with(std::move(options), command);
  } catch (const UnknownOption& unknown) {
    const std::string others = names_of_those_with(unknown.name);
    if (others.empty()) return wrong_usage(unknown.what(), name);
    return wrong_usage(name + " has no option " + unknown.name + "; it belongs to " + others, name);
  } catch (const WrongUsage& wrong) {
    return wrong_usage(wrong.what(), name);
  }
  std::cout << line.help(summary);
  return kClean;
}

template <typename Options>
NamedCommand named(const std::string& name, int (*command)(const Options&),
                   const std::string& summary) {
  static Options unread;
  return {name, summary, line_into(unread, name), [=](const std::vector<std::string>& arguments) {
            return run_line(name, summary, command, arguments);
          }};
}

const std::vector<NamedCommand>& commands() {
  static const std::vector<NamedCommand> all{
      named("build", build, "evaluate the course and write its site"),
      named("preview", preview, "show the course in a browser while it is being written"),
      named("lsp", lsp, "answer an editor: mistakes, completion and more while you write"),
      named("check", check, "evaluate the course and write nothing"),
      named("accept", accept,
            "evaluate the course, show where it differs from what is committed, and write what was "
            "computed: outputs, programs, regions, pictures"),
      named("explain", explain,
            "what each block depends on, and whether its result would be used again; or, by a "
            "message's "
            "name (E-output-differs), what it means and how it is cured"),
      named("try", try_exercise,
            "work on an exercise in a folder, and hear after each save what "
            "still fails"),
      named("grade", grade, "judge what others handed in"),
      named("list", list, "the lessons, and the state of each"),
      named("new", make_new,
            "begin a level, a lesson, a model, an example or an exercise of the course, or what is "
            "to "
            "check it"),
      named("init", init, "begin a course in a new folder"),
      named("doctor", doctor, "check what this machine has of all that courses need"),
      named("store", store,
            "forget the results that have gone unused longest, or exchange a course's with a "
            "shared store")};
  return all;
}

std::string help() {
  constexpr std::size_t indent = 21;
  std::string text = "usage: " + called_as() + " COMMAND [OPTIONS]\n\n";
  for (const NamedCommand& one : commands())
    text += help_line(one.line.form(), one.summary, indent);
  return text + help_line("--version", "which version this is", indent) + "\n" +
         our_command("COMMAND --help") +
         " shows what a command takes.\n"
         "\n"
         "Exit code: 0 clean, 1 the course has errors (after accept: those that it cannot fix),\n"
         "2 wrong usage, 3 a fault of mjcourse.\n";
}

}  // namespace

int run_command(const std::vector<std::string>& arguments) {
  if (arguments.empty()) return wrong_usage("which command?");
  if (arguments[0].empty()) return wrong_usage("which command? The first word is \"\"");
  const bool asks = arguments[0] == "--help" || arguments[0] == "-h" || arguments[0] == "help";
  if (asks && arguments.size() > 1) return run_command({arguments[1], "--help"});
  if (asks) {
    std::cout << help();
    return kClean;
  }
  if (arguments[0] == "--version") {
    std::cout << "mjcourse " MJCOURSE_VERSION "\n";
    return kClean;
  }
  const LogGuard told(false);  // also of what ends a command
  try {
    if (arguments[0] == kWorkCommand && arguments.size() == 3) {
      answer_questions(arguments[1], DiskFiles(arguments[2]));
      return kClean;
    }
    if (arguments[0] == kRenderCommand && arguments.size() == 2) {
      render_templates(DiskFiles(arguments[1]));
      return kClean;
    }
    std::vector<std::string> names;
    for (const NamedCommand& command : commands()) {
      if (arguments[0] == command.name)
        return command.run({arguments.begin() + 1, arguments.end()});
      names.push_back(command.name);
    }
    return wrong_usage("there is no command " + arguments[0] + "; " + suggest(arguments[0], names));
  } catch (const FolderRefused& refused) {
    return tell(Refusal{kWrongUsage, refused.what(), refused.cure()});
  } catch (const LostFile& lost) {
    return tell(Refusal{kCourseErrors, lost.what(),
                        "it was there a moment ago: make it readable, and start again"});
  } catch (const std::system_error& error) {
    return tell(failed_call(error));
  } catch (const std::exception& error) {
    std::cerr << "mjcourse: " << readable(error.what()) << '\n';
    return kOurFault;
  }
}

}  // namespace mjcourse
