#include "actions/native_program.h"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "base/files.h"
#include "base/sha256.h"
#include "memory_store.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

constexpr const char* kProgram = R"(#include <cstdio>
#include <cstdlib>
#include <kit.h>
int main(int count, char** words) {
  const std::string model = std::string(std::getenv("MJCOURSE_MODELS")) + "/a.xml";
  if (std::FILE* file = std::fopen(model.c_str(), "r")) std::fclose(file);
  std::FILE* records = std::fopen(std::getenv("MJCOURSE_RECORDS"), "a");
  std::fputs("{}\n", records);
  std::fclose(records);
  std::printf("%s %d\n", count > 1 ? words[1] : "none", kKit);
}
)";

// A store in which somebody may change what was kept: an answer behind the line of its question.
class ChangingStore : public MemoryStore {
 public:
  std::optional<Stored> find(const std::string& name) override {
    auto stored = MemoryStore::find(name);
    if (stored && from && name.starts_with("ac/")) stored->origin = *from;
    if (!change || !stored || !name.starts_with("ac/")) return stored;
    const std::size_t begin = stored->bytes.find('\n') + 1;
    stored->bytes = stored->bytes.substr(0, begin) + change(stored->bytes.substr(begin));
    return stored;
  }
  std::function<std::string(std::string)> change;
  std::optional<Origin> from;
};

// A course with a header and a model, and a store that outlives its runs.
class NativeProgramTest : public testing::Test {
 protected:
  NativeProgramTest() {
    write("examples/include/kit.h", "#pragma once\n#include <string>\nconst int kKit = 7;\n");
    write("models/a.xml", "<mujoco/>\n");
  }

  void write(const std::string& path, const std::string& bytes) const {
    write_file(root_ / path, bytes);
    std::this_thread::sleep_for(50ms);  // so that it was there before the work began
  }

  // What a run of mjcourse has.
  struct Run {
    explicit Run(const NativeProgramTest& test)
        : prints(test.root_), results(test.store_, prints), actions(test.root_), trace(test.root_) {
      actions.keep_in(results);
    }
    Fingerprints prints;
    ResultStore results;
    ActionStore actions;
    Trace trace;
  };

  NativeProgram program(Run& run, const std::string& text = kProgram) const {
    return NativeProgram({"a", "examples/a.cpp", text}, {root_, compiler_, run.actions, run.trace});
  }

  void compile_and_run(const std::string& text = kProgram,
                       const NativeRequest& request = {}) const {
    Run run(*this);
    NativeProgram one = program(run, text);
    ASSERT_TRUE(one.compile().succeeded) << one.compile().raw;
    one.run(request);
  }

  // In another run of mjcourse.
  std::string found(const std::string& text = kProgram, const NativeRequest& request = {}) const {
    Run run(*this);
    const auto known = program(run, text).find(request);
    return known ? known->outcome.out : "nothing";
  }

  const TemporaryFolder folder_;
  const std::filesystem::path root_ = folder_.path();
  const Compiler compiler_{Toolchain::find().value(), {root_ / "examples/include"}, std::nullopt};
  mutable ChangingStore store_;
};

TEST_F(NativeProgramTest, IsFoundWithAllThatItGave) {
  Run run(*this);
  NativeProgram one = program(run);
  EXPECT_FALSE(one.find({}));
  ASSERT_TRUE(one.compile().succeeded);
  const NativeRun ran = one.run({});
  EXPECT_EQ(ran.outcome.out, "none 7\n");
  EXPECT_EQ(ran.records, "{}\n");
  EXPECT_EQ(ran.files, (std::vector<std::string>{"examples/include/kit.h", "models/a.xml"}));

  Run later(*this);
  const auto known = program(later).find({});
  ASSERT_TRUE(known);
  EXPECT_EQ(known->outcome.out, ran.outcome.out);
  EXPECT_EQ(known->records, ran.records);
  EXPECT_EQ(known->files, ran.files);
  EXPECT_EQ(known->seconds, ran.seconds);
  // A task that takes it depends on the same.
  EXPECT_EQ(later.trace.names(), run.trace.names());
  EXPECT_EQ(later.trace.found().size(),
            run.trace.names().size() + run.trace.sets().size() + run.trace.headers().size());
}

// What is made of it is from there, too, also where it is remembered.
TEST_F(NativeProgramTest, IsFromWhereItWasFound) {
  Run first(*this);
  NativeProgram one = program(first);
  ASSERT_TRUE(one.compile().succeeded);
  one.run({});
  EXPECT_TRUE(first.trace.origin().is_made_here());
  store_.from = Origin::unsigned_one();
  Run later(*this);
  for (int i = 0; i < 2; ++i) {
    Trace task(root_);
    const ActionContext context{root_, compiler_, later.actions, task};
    ASSERT_TRUE(NativeProgram({"a", "examples/a.cpp", kProgram}, context).find({}));
    EXPECT_EQ(task.origin(), Origin::unsigned_one()) << i;
    task.clear();
    EXPECT_TRUE(task.origin().is_made_here());
  }
}

TEST_F(NativeProgramTest, IsNotFoundInTheSameRunOnceAFileHasChanged) {
  Run run(*this);
  NativeProgram one = program(run);
  ASSERT_TRUE(one.compile().succeeded);
  one.run({});
  Trace task(root_);
  const auto begin = std::chrono::system_clock::now();
  const ActionContext context{root_, compiler_, run.actions, task};
  EXPECT_TRUE(NativeProgram({"a", "examples/a.cpp", kProgram}, context).find({}));
  write("examples/include/kit.h", "#pragma once\n#include <string>\nconst int kKit = 8;\n");
  EXPECT_FALSE(program(run).find({}));
  // Nor is what somebody made of it kept.
  EXPECT_FALSE(run.results.keep({{"text", "t"}}, task, begin, "made of 7"));
}

TEST_F(NativeProgramTest, IsMadeAnewForAHeaderThatIsAddedBesideIt) {
  write("examples/a.h",
        "#include \"c.h\"\n#if __has_include(\"d.h\")\nconst int kD = 1;\n#else\n"
        "const int kD = 0;\n#endif\n");
  write("examples/include/c.h", "const int kC = 1;\n");
  const std::string text =
      "#include \"a.h\"\n#include <cstdio>\n"
      "int main() { std::printf(\"%d %d\\n\", kC, kD); }\n";
  compile_and_run(text);
  EXPECT_EQ(found(text), "1 0\n");
  write("examples/d.h", "");
  EXPECT_EQ(found(text), "nothing");
  compile_and_run(text);
  EXPECT_EQ(found(text), "1 1\n");
  write("examples/c.h", "const int kC = 2;\n");
  EXPECT_EQ(found(text), "nothing");
}

TEST_F(NativeProgramTest, IsFoundInTheSameRunWithoutAStore) {
  Run run(*this);
  ActionStore alone(root_);
  const ActionContext context{root_, compiler_, alone, run.trace};
  NativeProgram one({"a", "examples/a.cpp", kProgram}, context);
  ASSERT_TRUE(one.compile().succeeded);
  one.run({});
  EXPECT_TRUE(NativeProgram({"a", "examples/a.cpp", kProgram}, context).find({}));
}

TEST_F(NativeProgramTest, IsAnotherWithOtherArgumentsAndAnotherText) {
  compile_and_run(kProgram, {{"one"}});
  EXPECT_EQ(found(kProgram, {{"one"}}), "one 7\n");
  EXPECT_EQ(found(kProgram, {{"two"}}), "nothing");
  EXPECT_EQ(found(std::string(kProgram) + "\n", {{"one"}}), "nothing");
}

TEST_F(NativeProgramTest, IsMadeAnewForAnotherHeaderOrModel) {
  compile_and_run();
  EXPECT_EQ(found(), "none 7\n");
  write("models/b.xml", "<mujoco/>\n");
  EXPECT_EQ(found(), "none 7\n");
  write("models/a.xml", "<mujoco> </mujoco>\n");
  EXPECT_EQ(found(), "nothing");
  write("models/a.xml", "<mujoco/>\n");
  EXPECT_EQ(found(), "none 7\n");
  write("examples/include/kit.h", "#pragma once\n#include <string>\nconst int kKit = 8;\n");
  EXPECT_EQ(found(), "nothing");
}

TEST_F(NativeProgramTest, IsKeptOnlyWhereItRepeats) {
  compile_and_run("int main() { int unused; }\n");  // the compiler warns
  EXPECT_EQ(found("int main() { int unused; }\n"), "nothing");
  compile_and_run("int main() { return 3; }\n");
  EXPECT_EQ(found("int main() { return 3; }\n"), "nothing");
  EXPECT_EQ(found("int main() { return 3; }\n", {.exit_code = 3}), "nothing");
  compile_and_run("int main() { return 3; }\n", {.exit_code = 3});
  EXPECT_EQ(found("int main() { return 3; }\n", {.exit_code = 3}), "");
  EXPECT_EQ(found("int main() { return 3; }\n"), "nothing");
  // As this run took longer than it now may.
  EXPECT_EQ(found("int main() { return 3; }\n", {.seconds = 0, .exit_code = 3}), "nothing");
}

TEST_F(NativeProgramTest, IsNotKeptWhereTheCompilerMayHaveReadAFileThatItDoesNotList) {
  write("examples/include/blob.txt", "first");
  const std::string reads =
      "#include <cstdio>\nasm(\".data\\nblob: .incbin \\\"blob.txt\\\"\\n.byte 0\\n.text\");\n"
      "extern const char blob[] asm(\"blob\");\nint main() { std::puts(blob); }\n";
  Run run(*this);
  NativeProgram one = program(run, reads);
  ASSERT_TRUE(one.compile().succeeded) << one.compile().raw;
  EXPECT_EQ(one.run({}).outcome.out, "first\n");
  EXPECT_EQ(found(reads), "nothing");
  // Nor where a header of the course's may.
  write("examples/include/asks.h", "#ifdef __has_embed\n#endif\n");
  const std::string includes = "#include <asks.h>\nint main() {}\n";
  compile_and_run(includes);
  EXPECT_EQ(found(includes), "nothing");
  // But a word in which these letters stand means nothing.
  compile_and_run("int main() { int plasma = 0, embedded = plasma; return embedded; }\n");
  EXPECT_EQ(found("int main() { int plasma = 0, embedded = plasma; return embedded; }\n"), "");
}

TEST_F(NativeProgramTest, HearsOfAHeaderBesideItNoPathOfThisMachine) {
  write("examples/beside.h", "inline const char* file_of_header() { return __FILE__; }\n");
  const std::string text =
      "#include \"beside.h\"\n#include <cstdio>\n"
      "int main() { std::printf(\"%s %s\\n\", __FILE__, file_of_header()); }\n";
  compile_and_run(text);
  EXPECT_EQ(found(text), "examples/a.cpp examples/beside.h\n");
}

TEST_F(NativeProgramTest, IsNotKeptWhereThatIsNotWanted) {
  compile_and_run(kProgram, {.is_kept = false});
  EXPECT_EQ(found(), "nothing");
  compile_and_run();
  EXPECT_EQ(found(kProgram, {.is_kept = false}), "nothing");
}

TEST_F(NativeProgramTest, TellsItsListenerInPlaceOfItsRecords) {
  const std::string text =
      "#include <unistd.h>\n#include <cstdio>\n#include <cstdlib>\n"
      "int main() {\n  char answer = '-';\n"
      "  if (write(0, \"found\\n\", 6) != 6 || read(0, &answer, 1) != 1) return 1;\n"
      "  std::printf(\"%c %d %s\", answer, std::getenv(\"MJCOURSE_RECORDS\") != nullptr,\n"
      "              std::getenv(\"MJCOURSE_SEED\"));\n}\n";
  const auto request = [](const std::string& key, const std::string& answer) {
    return NativeRequest{.seed = "5", .listener = RunListener{key, [answer](std::string_view line) {
                                                                EXPECT_EQ(line, "found");
                                                                return answer;
                                                              }}};
  };
  {
    Run run(*this);
    NativeProgram one = program(run, text);
    ASSERT_TRUE(one.compile().succeeded) << one.compile().raw;
    const NativeRun ran = one.run(request("one", "1"));
    EXPECT_EQ(ran.outcome.out, "1 0 5");
    EXPECT_EQ(ran.records, "found\n");
  }
  EXPECT_EQ(found(text, request("one", "1")), "1 0 5");
  EXPECT_EQ(found(text, request("another", "0")), "nothing") << "it may be answered otherwise";
  EXPECT_EQ(found(text), "nothing");
}

TEST_F(NativeProgramTest, OfAStrangerIsCompiledWithTheHeadersThatItNamesAlone) {
  write("examples/beside.h", "#pragma once\ninline int beside() { return 8; }\n");
  write("examples/solution.h", "inline int secret() { return 9; }\n");
  const auto compiled = [&](const std::string& text) {
    Run run(*this);
    return NativeProgram({"a", "examples/a.cpp", text, false, true},
                         {root_, compiler_, run.actions, run.trace})
        .compile();
  };
  const std::string beside = "#include \"beside.h\"\n";
  EXPECT_TRUE(compiled(beside + "int main() { return beside(); }\n").succeeded);
  // A name that no reader of this text sees, as it is made by a macro.
  const Compiled other = compiled(beside + "#define A <solution.h>\n#include A\nint main() {}\n");
  EXPECT_NE(other.raw.find("'solution.h' file not found"), other.raw.npos) << other.raw;
  for (const char* way : {"../examples/solution.h", "../../examples/solution.h"}) {
    const std::string path = (root_ / "examples" / way).lexically_normal();
    const std::string text =
        beside + "asm(\".incbin \\\"" + path + "\\\"\");\nint main() { return 0; }\n";
    const Compiled included = compiled(text);
    EXPECT_FALSE(included.succeeded) << path;
  }
}

TEST_F(NativeProgramTest, ThatIsRefusedHasTheCompilersWords) {
  const std::string wrong = "#include <kit.h>\nint main() { return kMissing; }\n";
  Run run(*this);
  NativeProgram one = program(run, wrong);
  EXPECT_FALSE(one.find_refusal());
  ASSERT_TRUE(one.compile().refused());
  const std::string words = one.refusal();
  EXPECT_TRUE(words.starts_with("examples/a.cpp:2:21: error: ")) << words;
  EXPECT_EQ(words.find(root_), std::string::npos) << words;
  Run later(*this);
  EXPECT_EQ(program(later, wrong).find_refusal(), words);
}

TEST_F(NativeProgramTest, IsNotFoundInBytesOfSomebodyElses) {
  compile_and_run();
  store_.change = [](std::string answer) {
    answer.back() ^= 1;
    return answer;
  };
  EXPECT_EQ(found(), "nothing");
  // With the hash that belongs to it.
  store_.change = [](const std::string& answer) {
    std::string bytes = answer.substr(64);
    bytes.replace(bytes.find("models/a.xml"), 12, "../../../bad");
    return sha256(bytes) + bytes;
  };
  EXPECT_EQ(found(), "nothing");
  store_.change = [](const std::string& answer) { return answer; };
  EXPECT_EQ(found(), "none 7\n");
}

}  // namespace
}  // namespace mjcourse
