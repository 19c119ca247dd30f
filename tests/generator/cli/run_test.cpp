#include "cli/run.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "course/course.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

struct Ran {
  int code;
  std::string out, err;
};

Ran ran(const std::vector<std::string>& arguments) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run_command(arguments);
  return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

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
      "usage: mjcourse store [OPTIONS] prune\n"
      "\n"
      "forget the results that were not used for longest\n"
      "\n"
      "  prune          until no more than SIZE is left\n"
      "  --store DIR    where results are kept (default: the user's cache)\n"
      "  --keep SIZE    how much that is, as 500MB (default: 2GB)\n";
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

TEST(Run, ExplainsAMessageByItsName) {
  const Ran result = ran({"explain", "W-lesson-unlisted", "E-lesson-number"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out,
            "warning W-lesson-unlisted\n"
            "\n"
            "  A file is in the folder of a level, but `content/course.yaml` does not list it. It "
            "is not in the\n"
            "  site, and nothing in it is checked, perhaps contrary to what you expect. List it. "
            "If you are still\n"
            "  working on it, put `draft: true` in its front matter: the lesson then stays out of "
            "the site but is\n"
            "  checked all the same.\n"
            "\n"
            "  wrong: `lessons: [1.1-lesson]` beside a file `1.2-more.md`\n"
            "  right: `lessons: [1.1-lesson, 1.2-more]`\n"
            "\n"
            "error E-lesson-number\n"
            "\n"
            "  Two lessons of the course have the same number, so a link to it would be ambiguous. "
            "Give one of\n"
            "  them another number.\n"
            "\n"
            "  wrong: `1.2-state.md` and `1.2-joints.md`\n"
            "  right: `1.2-state.md` and `1.3-joints.md`\n");
}

TEST(Run, KnowsWhichMessagesThereAre) {
  const auto refused = [](const std::vector<std::string>& arguments) {
    const Ran result = ran(arguments);
    EXPECT_EQ(result.code, kWrongUsage);
    EXPECT_EQ(result.out, "");
    return result.err;
  };
  EXPECT_EQ(refused({"explain", "E-output-difers"}),
            "mjcourse: no message is called E-output-difers; did you mean `E-output-differs`?\n");
  EXPECT_EQ(refused({"explain", "E-frobnicate"}),
            "mjcourse: no message is called E-frobnicate; lesson A.9 of the author guide has them "
            "all\n");
  EXPECT_EQ(refused({"explain", "E-output-differs", "1.2"}),
            "mjcourse: explain takes messages' names or places of the course, and not both\n");
}

TEST(Run, NeedsACommandThatThereIs) {
  EXPECT_EQ(usage_error({}), "mjcourse: which command?");
  EXPECT_EQ(usage_error({"biuld"}), "mjcourse: there is no command biuld; did you mean `build`?");
  EXPECT_EQ(usage_error({"frobnicate"}),
            "mjcourse: there is no command frobnicate; known: build, preview, lsp, check, "
            "accept, explain, list, new, init, doctor, store");
}

TEST(Run, NeedsOptionsThatThereAre) {
  EXPECT_EQ(error_of({"check", "--corse", "x"}),
            "mjcourse: check has no option --corse; did you mean `--course`?");
  EXPECT_EQ(error_of({"build", "--outt", "x"}),
            "mjcourse: build has no option --outt; did you mean `--out`?");
  EXPECT_EQ(error_of({"accept", "1.2", "--dry-runn"}),
            "mjcourse: accept has no option --dry-runn; did you mean `--dry-run`?");
  EXPECT_EQ(error_of({"explain", "-s"}),
            "mjcourse: explain has no option -s; known: --course, --store");
  EXPECT_EQ(error_of({"check", "--out", "x"}),
            "mjcourse: check has no option --out; it belongs to build");
  EXPECT_EQ(error_of({"accept", "--timings"}),
            "mjcourse: accept has no option --timings; it belongs to build, check");
  EXPECT_EQ(error_of({"check", "1.2"}), "mjcourse: check takes only options, and not 1.2");
  EXPECT_EQ(error_of({"store"}),
            "mjcourse: store what? `mjcourse store prune` forgets old results");
}

TEST(Run, NeedsValuesOfTheirKind) {
  EXPECT_EQ(error_of({"check", "--course"}), "mjcourse: --course needs a folder");
  EXPECT_EQ(error_of({"build", "--course", "x", "--out"}), "mjcourse: --out needs a folder");
  EXPECT_EQ(error_of({"check", "--strict=yes"}), "mjcourse: --strict takes no value");
  for (const std::string number : {"0", "-1", "2x", "1025", "99999999999999999999"}) {
    EXPECT_EQ(error_of({"check", "--jobs", number}),
              "mjcourse: --jobs takes a number of threads, and not " + number);
  }
  EXPECT_EQ(error_of({"preview", "--port=65536"}),
            "mjcourse: --port takes a port from 1 to 65535, and not 65536");
  EXPECT_EQ(error_of({"preview", "--link", "vscode://"}),
            "mjcourse: --link takes an address with {file} in it, and not vscode://");
  EXPECT_EQ(error_of({"build", "--base-url", "example.org"}),
            "mjcourse: --base-url takes the address of a site, as https://example.org/course/, and "
            "not example.org");
  EXPECT_EQ(error_of({"check", "--format=xml"}),
            "mjcourse: --format takes text, json, github, sarif or junit, and not xml");
  EXPECT_EQ(error_of({"store", "prune", "--keep", "much"}),
            "mjcourse: --keep takes a size, as 2GB, and not much");
  EXPECT_EQ(error_of({"accept", ""}), "mjcourse: accept takes [WHERE...], and not \"\"");
}

class RunOnACourse : public testing::Test {
 protected:
  RunOnACourse() {
    setenv("MJCOURSE_ASSETS", MJCOURSE_ASSETS, 1);
    write("content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
    write("content/1-a/1.1-x.md", "---\ntitle: First\n---\nText.\n");
  }
  ~RunOnACourse() override { unsetenv("MJCOURSE_ASSETS"); }

  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }
  // Without the time it took, which is never the same.
  Ran on_course(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--course", folder_.path().string()});
    Ran result = ran(arguments);
    if (const std::size_t comma = result.out.find(" errors, "); comma != std::string::npos) {
      result.out.erase(comma + 7, result.out.find('\n', comma) - comma - 7);
    }
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(RunOnACourse, ChecksAndWritesNothing) {
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kClean);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out,
            "ok    1.1  First: nothing to verify\n1 lesson: nothing to verify; 0 errors\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(RunOnACourse, TellsAnotherToolOnStdoutAndAPersonOnStderr) {
  const std::string human = "ok    1.1  First: nothing to verify\n1 lesson: nothing to verify; ";
  for (const std::string format : {"json", "sarif", "junit"}) {
    const Ran result = on_course({"check", "--format=" + format});
    EXPECT_EQ(result.code, kClean);
    EXPECT_TRUE(result.err.starts_with(human)) << result.err;
    EXPECT_TRUE(result.out.starts_with(format == "junit" ? "<?xml" : "{")) << result.out;
  }
  EXPECT_EQ(on_course({"check", "--format", "github"}).out, "");
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n[dead](1.2)\n");
  const Ran result = on_course({"check", "--format", "github"});
  EXPECT_EQ(result.code, kCourseErrors);
  const std::string file =
      (folder_.path() / "content/1-a/1.1-x.md").lexically_relative(fs::current_path()).string();
  EXPECT_EQ(result.out,
            "::error file=" + file +
                ",line=4,col=8,endColumn=11,title=E-link-dead::there is no lesson `1.2` in "
                "this course%0Acure: add it to content/course.yaml\n");
}

TEST_F(RunOnACourse, ListsHowLessonsStand) {
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x, 1.2-y, 1.3-z]}]\n");
  write("content/1-a/1.3-z.md", "---\ntitle: 物理\ndraft: true\n---\nText.\n");
  write("content/1-a/1.1-x.md",
        "---\ntitle: Äpfel\nminutes: 7\n---\nTwo *words*, and $x$.\n\n"
        "```sh unchecked because=\"b\"\nx\n```\n");
  write("content/1-a/1.2-y.md", "---\ntitle: Second\ndraft: true\n---\nText.\n\n[dead](1.9)\n");
  const Ran result = on_course({"list"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_EQ(result.out,
            "     lesson          words  minutes  proved  asserted  open  changed\n"
            "1.1  Äpfel               4        7       1               1\n"
            "1.2  Second (draft)      2\n"
            "1.3  物理 (draft)        1\n"
            "1 error; `mjcourse check` shows them\n");
}

TEST_F(RunOnACourse, ListsWhenLessonsWereChanged) {
  const auto git = [&](const std::string& arguments) {
    const std::string command =
        "git -C " + folder_.path().string() + " -c user.name=A -c user.email=a@b " + arguments;
    EXPECT_EQ(std::system((command + " >/dev/null 2>&1").c_str()), 0) << command;
  };
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x, 1.2-y]}]\n");
  git("init");
  git("add content/1-a");
  setenv("GIT_COMMITTER_DATE", "2021-03-04T12:00:00Z", 1);
  git("commit -m x");
  unsetenv("GIT_COMMITTER_DATE");
  write("content/1-a/1.2-y.md", "---\ntitle: Second\n---\nText.\n");
  EXPECT_EQ(on_course({"list"}).out,
            "     lesson  words  minutes  proved  asserted  open  changed\n"
            "1.1  First       1                                   2021-03-04\n"
            "1.2  Second      1                                   not committed\n");
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\nMore text.\n");
  EXPECT_NE(on_course({"list"}).out.find("1.1  First       2                                   "
                                         "not committed\n"),
            std::string::npos);
}

TEST(Doctor, FindsWhatCoursesNeed) {
  setenv("MJCOURSE_ASSETS", MJCOURSE_ASSETS, 1);
  const TemporaryFolder folder;
  const std::string store = folder.path() / "not" / "made";
  const Ran result = ran({"doctor", "--store", store});
  EXPECT_EQ(result.code, kClean) << result.out;
  EXPECT_NE(result.out.find("  store     " + store + ", 0 bytes; "), std::string::npos)
      << result.out;
  EXPECT_TRUE(result.out.starts_with("mjcourse 0.")) << result.out;
  for (const std::string line :
       {"\nok    MuJoCo    2.2.2\n", "\nok    pictures  drawn by OSMesa", "compiler  clang ",
        "  site      ", "  sandbox   rlimits", "\nall that courses need is here\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
  unsetenv("MJCOURSE_ASSETS");
}

TEST(Doctor, HasACureForWhatIsMissing) {
  const char* found = std::getenv("PATH");
  const std::string path = found != nullptr ? found : "";
  setenv("PATH", "/nowhere", 1);
  setenv("MJCOURSE_ASSETS", "/nowhere", 1);
  const TemporaryFolder store;
  const Ran result = ran({"doctor", "--store", store.path().string()});
  setenv("PATH", path.c_str(), 1);
  unsetenv("MJCOURSE_ASSETS");
  EXPECT_EQ(result.code, kCourseErrors);
  for (const std::string line :
       {"\nFAIL  compiler  none: no program can be run\n"
        "      cure: `apt-get install clang-16 mold libmujoco-dev libeigen3-dev`\n",
        "\nFAIL  films     no ffmpeg: no figure can move\n      cure: `apt-get install ffmpeg`\n",
        "\nFAIL  site      its scripts and styles were not built: manifest.json: No such file or "
        "directory\n      cure: build them: `./mjcourse build`\n",
        "\n3 things that courses need are missing\n"}) {
    EXPECT_NE(result.out.find(line), std::string::npos) << line << result.out;
  }
}

TEST_F(RunOnACourse, BuildsTheSite) {
  const fs::path site = folder_.path() / "elsewhere";
  const Ran result = on_course({"build", "--out", site.string()});
  EXPECT_EQ(result.code, kClean);
  EXPECT_TRUE(result.out.ends_with("site: " + site.string() + "/index.html\n")) << result.out;
  EXPECT_TRUE(fs::exists(site / "index.html"));
  EXPECT_TRUE(fs::exists(site / "1-a" / "1.1-x.html"));
}

TEST_F(RunOnACourse, WritesIntoTheFolderThatItIsRunIn) {
  const fs::path before = fs::current_path();
  const TemporaryFolder here;
  fs::current_path(here.path());
  const Ran result =
      on_course({"build", "--out", "site", "--report", "report", "--trace", "trace.json"});
  fs::current_path(before);
  EXPECT_EQ(result.err, "");
  EXPECT_TRUE(result.out.ends_with("report: report/index.html\nsite: site/index.html\n"))
      << result.out;
  for (const char* file : {"site/index.html", "report/index.html", "trace.json"}) {
    EXPECT_TRUE(fs::exists(here.path() / file)) << file;
  }
}

TEST_F(RunOnACourse, BuildsMoreLessonsThanStayAwake) {
  const int last = static_cast<int>(kMostAwake) + 1;
  std::string names;
  for (int i = 1; i <= last; ++i) {
    const std::string number = "1." + std::to_string(i);
    names += number + "-x, ";
    write("content/1-a/" + number + "-x.md",
          "---\ntitle: T\n---\nThe text of " + number + ".\n\n```sh unchecked\nx\n```\n");
  }
  write("content/course.yaml",
        "title: C\nlevels: [{folder: 1-a, title: A, lessons: [" + names + "]}]\n");
  EXPECT_EQ(on_course({"build"}).code, kClean);
  const DiskFiles site(folder_.path() / "build/site");
  for (const std::string& number : {std::string("1.1"), "1." + std::to_string(last)}) {
    const std::string page = site.read("1-a/" + number + "-x.html").value();
    EXPECT_NE(page.find("The text of " + number + "."), std::string::npos) << number;
    EXPECT_NE(page.find("<figure class=\"example\">"), std::string::npos) << number;
  }
}

TEST_F(RunOnACourse, BuildsNoSiteOfACourseWithErrors) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n> [!nte] x\n\n[dead](1.2)\n");
  const Ran result = on_course({"build"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_EQ(result.err,
            R"(content/1-a/1.1-x.md:4:5: error: there is no callout `nte` [E-callout-kind]
  4 | > [!nte] x
    |     ^~~
  cure: did you mean `note`?

content/1-a/1.1-x.md:6:8: error: there is no lesson `1.2` in this course [E-link-dead]
  6 | [dead](1.2)
    |        ^~~
  cure: add it to content/course.yaml

)");
  EXPECT_EQ(result.out,
            "FAIL  1.1  First: nothing verified; 2 errors\n"
            "1 lesson: nothing verified; 2 errors\n"
            "no site was written: mend the errors first\n");
  EXPECT_FALSE(fs::exists(folder_.path() / "build"));
}

TEST_F(RunOnACourse, ChecksStrictlyWhenAsked) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n```sh unchecked\nls\n```\n");
  EXPECT_EQ(on_course({"check"}).code, kClean);
  const Ran strict = on_course({"check", "--strict"});
  EXPECT_EQ(strict.code, kCourseErrors);
  EXPECT_TRUE(strict.err.starts_with(
      "content/1-a/1.1-x.md:4:1: error: nobody runs this code, and nothing says why"))
      << strict.err;
}

TEST_F(RunOnACourse, ReportsAlsoWhatFailed) {
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n$\\alhpa$\n");
  const fs::path report = folder_.path() / "report";
  const Ran result = on_course({"check", "--report", report.string()});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.ends_with("report: " + report.string() + "/index.html\n")) << result.out;
  const std::string page = DiskFiles(report).read("index.html").value();
  EXPECT_NE(page.find("\\alpha"), std::string::npos);
  EXPECT_TRUE(fs::exists(report / "verification.json"));
}

TEST_F(RunOnACourse, FailsALessonWhoseModelIsWrong) {
  write("models/bad.xml", "<mujoco>\n  <geom/>\n</mujoco>\n");
  write("content/1-a/1.1-x.md",
        "---\ntitle: First\n---\n```lab simlab\n{\"title\": \"T\", \"model\": \"bad\", \"alt\": "
        "\"A\"}\n```\n");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.out.starts_with("FAIL  1.1")) << result.out;
}

TEST_F(RunOnACourse, SaysThatThereIsNoCourse) {
  fs::remove(folder_.path() / "content" / "course.yaml");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kCourseErrors);
  EXPECT_TRUE(result.err.starts_with("content/course.yaml: error: cannot read ")) << result.err;
}

TEST_F(RunOnACourse, BlamesItselfForWhatNoAuthorCanMend) {
  setenv("MJCOURSE_ASSETS", "/nowhere", 1);
  write("content/1-a/1.1-x.md", "---\ntitle: First\n---\n$x$\n");
  const Ran result = on_course({"check"});
  EXPECT_EQ(result.code, kOurFault);
  EXPECT_EQ(
      result.err,
      "mjcourse: the site's assets are not built: script/typeset.js: No such file or directory\n");
}

TEST_F(RunOnACourse, ReplacesNothingThatItDidNotMake) {
  write("mine/precious.txt", "work of years");
  const fs::path mine = folder_.path() / "mine";
  const std::string said = "mjcourse: " + mine.string() +
                           " holds something that no build made, and would be replaced\n"
                           "  cure: name an empty or a new folder\n";
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"build", "--out"}, {"check", "--report"}}) {
    const Ran result = on_course({words[0], words[1], mine.string()});
    EXPECT_EQ(result.code, kWrongUsage) << words[0];
    EXPECT_EQ(result.err, said) << words[0];
  }
  EXPECT_EQ(read_file(mine / "precious.txt").value(), "work of years");
}

}  // namespace
}  // namespace mjcourse
