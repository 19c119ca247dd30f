#include "cli/command_options.h"

#include <re2/re2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <ctime>
#include <string_view>
#include <utility>

#include "cli/ci_files.h"
#include "cli/shard.h"
#include "cli/size.h"
#include "course/web_address.h"
#include "evaluate/hand_in.h"
#include "remote/server.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostJobs = 1024;
constexpr int kLastPort = 65535;

constexpr const char* kWhereHelp =
    "a lesson (1.2, its slug or its path), or the block at one of its lines (1.2:210); none "
    "means all";

// A whole number from 1 to `last`.
template <typename Number>
bool take_number(const std::string& text, Number last, Number& to) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, to);
  return read.ec == std::errc() && read.ptr == end && to > 0 && to <= last;
}

// "2026-11-30T23:59", of this machine's time zone, or with "Z" of none; a day alone ends with its
// last minute.
std::optional<std::chrono::sys_seconds> time_of(const std::string& text) {
  static const RE2 form(R"((\d{4})-(\d\d)-(\d\d)(?:[T ](\d\d):(\d\d)(?::(\d\d))?)?(Z?))");
  int year = 0, month = 0, day = 0, hour = 23, minute = 59, second = 59;
  std::string hours, minutes, seconds, zone;
  if (!RE2::FullMatch(text, form, &year, &month, &day, &hours, &minutes, &seconds, &zone))
    return {};
  if (!hours.empty()) {
    hour = std::stoi(hours);
    minute = std::stoi(minutes);
    second = seconds.empty() ? 0 : std::stoi(seconds);
  }
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok() || hour > 23 || minute > 59 || second > 59) return {};
  std::tm fields{};
  fields.tm_year = year - 1900;
  fields.tm_mon = month - 1;
  fields.tm_mday = day;
  fields.tm_hour = hour;
  fields.tm_min = minute;
  fields.tm_sec = second;
  fields.tm_isdst = -1;
  const std::time_t time = zone.empty() ? std::mktime(&fields) : timegm(&fields);
  return std::chrono::sys_seconds(std::chrono::seconds(time));
}

// The first is for people, the others for another tool.
constexpr std::array<std::pair<std::string_view, Format>, 5> kFormats{{{"text", Format::text},
                                                                       {"json", Format::json},
                                                                       {"github", Format::github},
                                                                       {"sarif", Format::sarif},
                                                                       {"junit", Format::junit}}};

// "json, github or sarif": all of kFormats from `first` on.
std::string format_names(std::size_t first) {
  std::string names(kFormats.at(first).first);
  for (std::size_t i = first + 1; i < kFormats.size(); ++i) {
    names += (i + 1 < kFormats.size() ? ", " : " or ") + std::string(kFormats[i].first);
  }
  return names;
}

std::vector<std::string> all_formats() {
  std::vector<std::string> names;
  for (const auto& [name, format] : kFormats) names.emplace_back(name);
  return names;
}

bool take_format(const std::string& name, Format& to) {
  const auto* named = std::find_if(kFormats.begin(), kFormats.end(),
                                   [&](const auto& one) { return one.first == name; });
  if (named != kFormats.end()) to = named->second;
  return named != kFormats.end();
}

void add_course(CommandLine& line, std::filesystem::path& course) {
  line.path("--course", kFolder, "a folder with content/, models/ and examples/ (default: .)",
            course);
}

void add_store(CommandLine& line, std::filesystem::path& store) {
  line.path("--store", kFolder, "where results are kept (default: the user's cache)", store);
}

void add_stores(CommandLine& line, std::filesystem::path& store, SharedPlace& shared) {
  add_store(line, store);
  line.value("--store-url", {"URL", "an address that begins with http://, https:// or unix:/"},
             "a store that many machines share, in Bazel's HTTP cache protocol; none: only --store "
             "(default: what MJCOURSE_STORE_URL or ~/.config/mjcourse/config.yaml says)",
             [&](const std::string& value) {
               shared.url = value;
               if (value == kNoServer) return true;
               const auto address = read_store_address(value);
               if (!address) throw WrongUsage("--store-url: " + address.error());
               return true;
             });
  line.flag("--store-read-only", "put nothing into the shared store", shared.read_only);
}

void add_jobs(CommandLine& line, std::size_t& jobs) {
  line.value("--jobs", {"N", "a number of threads"},
             "the number of threads (default: one for each core)",
             [&](const std::string& value) { return take_number(value, kMostJobs, jobs); });
}

void add_evaluation(CommandLine& line, CourseOptions& options) {
  add_stores(line, options.store, options.shared);
  add_jobs(line, options.jobs);
  line.flag("--unsafe-without-landlock",
            "run a course's programs where the kernel has no Landlock to keep them from your "
            "files: for courses whose every program you trust",
            options.without_landlock);
}

void add_report(CommandLine& line, VerifyOptions& options) {
  line.path("--report", kFolder,
            "write what was verified, and how, to DIR/index.html and verification.json",
            options.report);
  line.flag("--timings", "print what took longest", options.timings);
  line.path("--trace", kFile, "write what was worked on when, for a browser's trace viewer",
            options.trace);
}

}  // namespace

void declare(CommandLine& line, AcceptOptions& options) {
  line.words("[WHERE...]", kWhereHelp, options.where);
  add_course(line, options.course);
  line.flag("--dry-run",
            "show the differences and write nothing; the exit code is 1 if there are any",
            options.dry_run);
  add_evaluation(line, options);
}

void declare(CommandLine& line, BuildOptions& options) {
  add_course(line, options.course);
  line.path("--out", kFolder, "where the site is written (default: build/site in the course)",
            options.out);
  line.value("--base-url", {"URL", "the address of a site, such as https://example.org/course/"},
             "where the site is published, whatever course.yaml says",
             [&](const std::string& value) {
               options.base_url = site_root(value);
               return !site_address_fault(value);
             });
  line.flag("--compress",
            "write NAME.br and NAME.gz beside each text file, for servers that send these",
            options.compress);
  line.flag("--without-solutions",
            "leave the solutions of exercises out of the site, for a class that hands in its own",
            options.without_solutions);
  add_report(line, options);
  add_evaluation(line, options);
}

void declare(CommandLine& line, CheckOptions& options) {
  add_course(line, options.course);
  line.flag("--strict", "treat warnings as errors, and ask for a reason for all that is not proved",
            options.strict);
  line.value(
      "--format", {"NAME", format_names(0)},
      "write the messages for another tool to stdout, and for you to stderr: " + format_names(1) +
          " (default: text)",
      [&](const std::string& value) { return take_format(value, options.format); }, all_formats());
  line.value(
      "--shard", {"I/N", "a share, such as 2/4"},
      "do the share of the I-th of N jobs, which have one store; auto: as Slurm, Kubernetes, "
      "GitLab or Buildkite number this job",
      [&](const std::string& value) {
        const auto shard = shard_of(value);
        if (!shard) throw WrongUsage(shard.error());
        options.shard = *shard;
        return true;
      });
  add_report(line, options);
  add_evaluation(line, options);
}

void declare(CommandLine& line, DoctorOptions& options) {
  add_stores(line, options.store, options.shared);
}

void declare(CommandLine& line, ExplainOptions& options) {
  line.words("[WHERE...]",
             std::string(kWhereHelp) + "; or a message's name, such as E-output-differs",
             options.where);
  line.flag("--json", "write all that each block depends on, for --against on another machine",
            options.json);
  line.path("--against", kFile,
            "say in what this machine differs from the one on which --json wrote FILE",
            options.against);
  add_course(line, options.course);
  add_stores(line, options.store, options.shared);
}

void declare(CommandLine& line, GradeOptions& options) {
  line.words("DIR...", "the folder of each student, with NAME.cpp or NAME/NAME.cpp of an exercise",
             options.hand_ins);
  line.path("--against", kFolder, "the course, with its solutions (default: .)", options.course);
  line.value("--exercise", {"NAME", "an exercise, or a lesson's number"},
             "grade this one, also where it was not handed in; may be said several times (default: "
             "those that somebody handed in)",
             [&](const std::string& value) {
               options.exercises.push_back(value);
               return true;
             });
  static const std::vector<std::string> names{"text", "json", "junit", "csv"};
  line.value(
      "--format", {"NAME", "text, json, junit or csv"}, "text, json, junit or csv (default: text)",
      [&](const std::string& value) {
        const auto named = std::ranges::find(names, value);
        options.format = static_cast<GradeFormat>(named - names.begin());
        return named != names.end();
      },
      names);
  line.path("--out", kFolder,
            "keep each verdict in DIR as it comes, and at the end tables and a letter for each "
            "student; a second run goes on from there",
            options.results);
  line.value("--due", {"TIME", "a time, such as 2026-11-30T23:59 (here) or 2026-11-30T23:59Z"},
             "say how late a file was that was changed after TIME", [&](const std::string& value) {
               options.due = time_of(value);
               return options.due.has_value();
             });
  line.value("--seed", {"N", "a whole number from 1 on"},
             "draw the inputs of the checks from N, as an earlier run (default: a new one)",
             [&](const std::string& value) {
               options.seed = value;
               return is_seed(value);
             });
  add_evaluation(line, options);
}

void declare(CommandLine& line, InitOptions& options) {
  line.words("DIR [TITLE]", "a new or an empty folder, and the course's title in quotes",
             options.words);
  line.value(
      "--ci", {"NAME", "github, gitlab, slurm or kubernetes"},
      "what is to check it: github, gitlab, slurm or kubernetes (default: github)",
      [&](const std::string& value) {
        options.ci = value;
        return std::ranges::find(ci_names(), value) != ci_names().end();
      },
      ci_names());
}

void declare(CommandLine& line, ListOptions& options) {
  add_course(line, options.course);
  add_stores(line, options.store, options.shared);
  add_jobs(line, options.jobs);
}

void declare(CommandLine& line, LspOptions& options) {
  line.value("--course", kFolder, "the course (default: the folder that is open in the editor)",
             [&](const std::string& value) {
               options.course = value;
               options.course_named = true;
               return true;
             });
  add_evaluation(line, options);
}

void declare(CommandLine& line, NewOptions& options) {
  line.words("KIND NAME",
             "of a level or a lesson, then its title: `level 2-dynamics \"Dynamics\"`, "
             "`lesson 2-dynamics \"Forces\"`; of a model: `model pendulum`; of an example, then "
             "its model: `example l2_1_forces pendulum`; of an exercise, likewise; of what is to "
             "check the course: "
             "`ci gitlab`, or github, slurm, kubernetes",
             options.words);
  add_course(line, options.course);
}

void declare(CommandLine& line, PreviewOptions& options) {
  add_course(line, options.course);
  line.value("--port", {"N", "a port from 1 to 65535"},
             "where it answers (default: the first free one from 8000 on)",
             [&](const std::string& value) {
               return take_number(value, kLastPort, options.port.emplace());
             });
  line.flag("--open", "open a browser", options.open);
  line.value(
      "--link", {"FORM", "an address with {file} in it"},
      "how a page opens your editor, with {file}, {line}, {column} (default: " + options.link + ")",
      [&](const std::string& value) {
        options.link = value;
        return value.find("{file}") != value.npos;
      });
  add_evaluation(line, options);
}

void declare(CommandLine& line, TryOptions& options) {
  line.words("LESSON [EXERCISE]",
             "the lesson (1.2, its slug or its path) and, where it has several, the exercise",
             options.words);
  add_course(line, options.course);
  line.path("--out", kFolder, "where you work (default: a folder called as the exercise is)",
            options.folder);
  line.flag("--once", "judge the text once; the exit code is 1 unless all checks hold",
            options.once);
  line.flag("--open", "open the program in an editor", options.open);
  add_evaluation(line, options);
}

void declare(CommandLine& line, StoreOptions& options) {
  line.words(
      "prune|push|pull|key FILE",
      "`prune` until no more than SIZE is left; `push` what is kept of the course to the "
      "shared store; `pull` what that has of it; `key` makes a key to sign entries with, into a "
      "new file",
      options.words);
  add_course(line, options.course);
  add_stores(line, options.store, options.shared);
  line.value("--keep", {"SIZE", "a size, such as 2GB"},
             "how much to keep, such as 500MB (default: 2GB)", [&](const std::string& value) {
               const auto bytes = read_size(value);
               options.keep = bytes.value_or(0);
               return bytes.has_value();
             });
}

}  // namespace mjcourse
