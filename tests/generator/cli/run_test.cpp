#include "cli/run.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "cli/ran.h"

namespace mjcourse {
namespace {

// What a wrong command line is answered with.
std::string usage_error(const std::vector<std::string>& arguments,
                        const std::string& help = "--help` shows the commands") {
  const Ran result = ran(arguments);
  EXPECT_EQ(result.code, kWrongUsage);
  EXPECT_EQ(result.out, "");
  const std::string end = "\n`mjcourse " + help + "\n";
  EXPECT_TRUE(result.err.ends_with(end)) << result.err;
  return result.err.substr(0, result.err.size() - end.size());
}

std::string error_of(const std::vector<std::string>& arguments) {
  return usage_error(arguments, arguments[0] + " --help` shows what it takes");
}

TEST(Run, HelpsOnStdout) {
  for (const char* word : {"--help", "-h", "help"}) {
    const Ran result = ran({word});
    EXPECT_EQ(result.code, kClean);
    EXPECT_TRUE(result.out.starts_with("usage: mjcourse COMMAND [OPTIONS]\n")) << result.out;
    EXPECT_NE(result.out.find("\n  --version          which version this is\n"), std::string::npos);
    EXPECT_EQ(result.err, "");
  }
}

TEST(Run, HelpsWithOneCommand) {
  const std::string help =
      "usage: mjcourse store [OPTIONS] prune|push|pull|key FILE\n"
      "\n"
      "forget the results that have gone unused longest, or exchange a course's with a shared "
      "store\n"
      "\n"
      "  prune|push|pull|key FILE"
      "\n                 `prune` until no more than SIZE is left; `push` what is kept of the "
      "course "
      "to the\n"
      "                 shared store; `pull` what that has of it; `key` makes a key to sign "
      "entries with,\n"
      "                 into a new file\n"
      "  --course DIR   a folder with content/, models/ and examples/ (default: .)\n"
      "  --store DIR    where results are kept (default: the user's cache)\n"
      "  --store-url URL\n"
      "                 a store that many machines share, in Bazel's HTTP cache protocol; none: "
      "only\n"
      "                 --store (default: what MJCOURSE_STORE_URL or "
      "~/.config/mjcourse/config.yaml "
      "says)\n"
      "  --store-read-only\n"
      "                 put nothing into the shared store\n"
      "  --keep SIZE    how much to keep, such as 500MB (default: 2GB)\n";
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"store", "--help"}, {"store", "prune", "-h"}, {"help", "store"}}) {
    const Ran result = ran(arguments);
    EXPECT_EQ(result.code, kClean);
    EXPECT_EQ(result.out, help);
    EXPECT_EQ(result.err, "");
  }
}

TEST(Run, HelpsWithEveryCommand) {
  for (const std::string command : {"accept", "build", "check", "doctor", "explain", "init", "list",
                                    "lsp", "new", "preview", "store"}) {
    const Ran result = ran({command, "--help"});
    EXPECT_EQ(result.code, kClean);
    EXPECT_TRUE(result.out.starts_with("usage: mjcourse " + command + " [OPTIONS]")) << result.out;
    EXPECT_NE(ran({"--help"}).out.find("\n  " + command + " "), std::string::npos);
  }
}

TEST(Run, GoesByTheNameThatItWasCalledBy) {
  setenv("MJCOURSE_CALLED", "./mjcourse", 1);
  const Ran help = ran({"--help"}), wrong = ran({"biuld"});
  unsetenv("MJCOURSE_CALLED");
  EXPECT_TRUE(help.out.starts_with("usage: ./mjcourse COMMAND [OPTIONS]\n")) << help.out;
  EXPECT_EQ(wrong.err,
            "mjcourse: there is no command biuld; did you mean `build`?\n"
            "`./mjcourse --help` shows the commands\n");
}

TEST(Run, TellsItsVersion) {
  const Ran result = ran({"--version"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_TRUE(result.out.starts_with("mjcourse 0.")) << result.out;
}

TEST(Run, NeedsACommandThatThereIs) {
  EXPECT_EQ(usage_error({}), "mjcourse: which command?");
  EXPECT_EQ(usage_error({""}), "mjcourse: which command? The first word is \"\"");
  EXPECT_EQ(usage_error({"help", ""}), "mjcourse: which command? The first word is \"\"");
  EXPECT_EQ(usage_error({"biuld"}), "mjcourse: there is no command biuld; did you mean `build`?");
  EXPECT_EQ(usage_error({"frobnicate"}),
            "mjcourse: there is no command frobnicate; known: build, preview, lsp, check, "
            "accept, explain, try, grade, list, new, init, doctor, …");
}

TEST(Run, NeedsOptionsThatThereAre) {
  EXPECT_EQ(error_of({"check", "--corse", "x"}),
            "mjcourse: check has no option --corse; did you mean `--course`?");
  EXPECT_EQ(error_of({"build", "--outt", "x"}),
            "mjcourse: build has no option --outt; did you mean `--out`?");
  EXPECT_EQ(error_of({"accept", "1.2", "--dry-runn"}),
            "mjcourse: accept has no option --dry-runn; did you mean `--dry-run`?");
  EXPECT_EQ(error_of({"explain", "-s"}),
            "mjcourse: explain has no option -s; known: --json, --against, --course, --store, "
            "--store-url, "
            "--store-read-only");
  EXPECT_EQ(error_of({"check", "--out", "x"}),
            "mjcourse: check has no option --out; it belongs to build, try, grade");
  EXPECT_EQ(error_of({"accept", "--timings"}),
            "mjcourse: accept has no option --timings; it belongs to build, check");
  EXPECT_EQ(error_of({"check", "1.2"}), "mjcourse: check takes only options, not 1.2");
  EXPECT_EQ(error_of({"check", ""}), "mjcourse: check takes only options, not \"\"");
  EXPECT_EQ(error_of({"store"}), "mjcourse: store what? prune, push, pull or key");
}

TEST(Run, NeedsValuesOfTheirKind) {
  EXPECT_EQ(error_of({"check", "--course"}), "mjcourse: --course needs a folder");
  EXPECT_EQ(error_of({"build", "--course", "x", "--out"}), "mjcourse: --out needs a folder");
  EXPECT_EQ(error_of({"check", "--strict=yes"}), "mjcourse: --strict takes no value");
  for (const std::string number : {"0", "-1", "2x", "1025", "99999999999999999999"}) {
    EXPECT_EQ(error_of({"check", "--jobs", number}),
              "mjcourse: --jobs takes a number of threads, not " + number);
  }
  EXPECT_EQ(error_of({"preview", "--port=65536"}),
            "mjcourse: --port takes a port from 1 to 65535, not 65536");
  EXPECT_EQ(error_of({"preview", "--link", "vscode://"}),
            "mjcourse: --link takes an address with {file} in it, not vscode://");
  EXPECT_EQ(
      error_of({"build", "--base-url", "example.org"}),
      "mjcourse: --base-url takes the address of a site, such as https://example.org/course/, "
      "not example.org");
  EXPECT_EQ(error_of({"check", "--format=xml"}),
            "mjcourse: --format takes text, json, github, sarif or junit, not xml");
  EXPECT_EQ(error_of({"check", "--format", "sarf"}),
            "mjcourse: --format takes text, json, github, sarif or junit, not sarf; did you "
            "mean `sarif`?");
  EXPECT_EQ(error_of({"store", "prune", "--keep", "much"}),
            "mjcourse: --keep takes a size, such as 2GB, not much");
  EXPECT_EQ(error_of({"accept", ""}), "mjcourse: accept takes [WHERE...], not \"\"");
}

// A control character is a command for a terminal, and a line with `::` one for GitHub's runner.
TEST(Run, TellsTheNamesOfFilesAsAnyTerminalShowsThem) {
  const TemporaryFolder folder;
  const std::string odd = "\x1b[2J\n::error::forged", shown = R"(\x1b[2J\n::error::forged)";
  write_file(folder.path() / odd, "");
  const std::string in = folder.path().string();
  EXPECT_EQ(ran({"init", in}).err,
            "mjcourse: " + in + " is not empty: it has " + shown +
                "\n  cure: name a new or an empty folder; `mjcourse new` adds to a course\n");
}

}  // namespace
}  // namespace mjcourse
