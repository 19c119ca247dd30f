#include "toolchain/compiler.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/subprocess.h"
#include "toolchain/warm_header.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A course with a header of its own, and a cache of its own.
class CompilerTest : public testing::Test {
 protected:
  CompilerTest() {
    write_kit("inline int twice(int x) { return 2 * x; }\n");
    write_file(include() / "mjcourse/handlers.cpp", "extern int handled;\nint handled = 7;\n");
  }

  fs::path include() const { return folder_.path() / "course/examples/include"; }
  fs::path cache() const { return folder_.path() / "cache"; }
  void write_kit(const std::string& text) {
    write_file(include() / "kit/kit.h", "#pragma once\n#include <stdio.h>\n" + text);
  }

  // Each compiler is a new run's, which first makes the warm header where there is none.
  Compiled compile(const std::string& program, bool with_cache = true, bool optimize = false,
                   Warmth warmth = Warmth::thorough) {
    const Compiler compiler(Toolchain::find().value(), {include()},
                            with_cache ? std::optional(cache()) : std::nullopt);
    const std::vector<std::string> roots = warm_roots(program, {include()});
    if (with_cache && !compiler.has_header(roots)) compiler.make_header(roots, warmth);
    return compile_with(compiler, program, optimize);
  }
  Compiled compile_with(const Compiler& compiler, const std::string& program,
                        bool optimize = false) {
    const TemporaryFolder work;
    const fs::path source = work.path() / "a.cpp", binary = work.path() / "a";
    write_file(source, "#line 1 \"a.cpp\"\n" + program);
    Compiled compiled = compiler.compile(source, binary, work.path(), optimize);
    if (compiled.succeeded) {
      Command command;
      command.arguments = {binary.string()};
      exit_code_ = run(command).code;
    }
    return compiled;
  }

  // The entries of the cache that have a warm header.
  std::vector<fs::path> headers() const {
    std::vector<fs::path> found;
    for (const auto& file : fs::recursive_directory_iterator(cache())) {
      if (file.path().filename() == "header.pch") found.push_back(file.path());
    }
    return found;
  }

  TemporaryFolder folder_;
  int exit_code_ = -1;  // of the program that was compiled last
};

const std::string kTwice =
    "#include <kit/kit.h>\nextern int handled;\nint main() { return twice(handled); }\n";

// Of every list that `compiled` gives.
std::vector<std::string> all_dependencies(const Compiled& compiled) {
  std::vector<std::string> all = compiled.dependencies.value();
  for (const auto& entry : {compiled.header, compiled.handlers}) {
    if (entry) all.insert(all.end(), entry->inputs.begin(), entry->inputs.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

TEST_F(CompilerTest, CompilesTheSameWithAWarmHeaderAndWithout) {
  const Compiled warm = compile(kTwice);
  EXPECT_TRUE(warm.succeeded);
  EXPECT_EQ(warm.raw, "");
  EXPECT_TRUE(warm.header);
  EXPECT_TRUE(warm.handlers);
  EXPECT_EQ(exit_code_, 14);
  const Compiled plain = compile(kTwice, false);
  EXPECT_EQ(plain.raw, "");
  EXPECT_FALSE(plain.header);
  EXPECT_FALSE(plain.handlers);
  EXPECT_EQ(exit_code_, 14);
  EXPECT_EQ(all_dependencies(warm), all_dependencies(plain));
}

TEST_F(CompilerTest, CompilesTheSameWithAQuickHeader) {
  const Compiled quick = compile(kTwice, true, false, Warmth::quick);
  EXPECT_EQ(quick.raw, "");
  EXPECT_TRUE(quick.header);
  EXPECT_FALSE(fs::exists(quick.header->folder / "header.o"));
  EXPECT_EQ(exit_code_, 14);
  EXPECT_EQ(all_dependencies(quick), all_dependencies(compile(kTwice, false)));
}

TEST_F(CompilerTest, WaitsForNoHeader) {
  const Compiler compiler(Toolchain::find().value(), {include()}, cache());
  EXPECT_FALSE(compiler.has_header({"kit/kit.h"}));
  const Compiled compiled = compile_with(compiler, kTwice);
  EXPECT_FALSE(compiled.header);
  EXPECT_EQ(exit_code_, 14);
  EXPECT_TRUE(headers().empty());
}

// Another checkout has the same headers elsewhere.
TEST_F(CompilerTest, SharesAHeaderWithACourseThatLiesElsewhere) {
  ASSERT_TRUE(compile(kTwice).header);
  const fs::path moved = folder_.path() / "moved/include";
  fs::create_directory(moved.parent_path());
  fs::rename(include(), moved);
  const Compiler compiler(Toolchain::find().value(), {moved}, cache());
  const Compiled compiled = compile_with(compiler, kTwice);
  EXPECT_EQ(compiled.raw, "");
  ASSERT_TRUE(compiled.header);
  EXPECT_EQ(compiled.header->inputs[0], (moved / "kit/kit.h").string());
  EXPECT_EQ(compiled.handlers->inputs[0], (moved / "mjcourse/handlers.cpp").string());
  EXPECT_EQ(exit_code_, 14);
  EXPECT_EQ(headers().size(), 1U);
  for (const fs::path& header : headers()) {
    const std::string bytes = read_file(header).value();
    EXPECT_EQ(bytes.find(folder_.path().string()), bytes.npos);
  }
}

// What a program prints of its place is the same with a warm header, and wherever the course lies.
TEST_F(CompilerTest, NamesTheFileOfAHeaderAlike) {
  write_kit(
      "inline int is_path(const char* path) {\n"
      "  return __builtin_strcmp(path, \"examples/include/kit/kit.h\") == 0;\n}\n"
      "inline const char* here() { return __FILE__; }\n");
  const std::string program = "#include <kit/kit.h>\nint main() { return is_path(here()); }\n";
  for (const bool warm : {true, false}) {
    EXPECT_EQ(compile(program, warm).header != nullptr, warm);
    EXPECT_EQ(exit_code_, 1) << warm;
  }
}

TEST_F(CompilerTest, WarmsEigen) {
  const Compiled compiled =
      compile("#include <Eigen/Core>\nint main() { return Eigen::VectorXd::Ones(3).sum(); }\n");
  EXPECT_TRUE(compiled.header);
  EXPECT_EQ(exit_code_, 3) << compiled.raw;
}

// A thorough header takes half a minute, so it is made of one of them alone; what stands in it
// compiles behind each.
TEST_F(CompilerTest, UsesOfEigenWhatAProgramIncludes) {
  const std::string uses =
      DiskFiles(MJCOURSE_ROOT).read("generator/toolchain/warm_eigen.hpp").value();
  for (const char* header : {"Geometry", "Cholesky", "Dense"}) {
    const TemporaryFolder work;
    write_file(work.path() / "a.cpp", "#include <Eigen/" + std::string(header) + ">\n" + uses);
    std::vector<std::string> command = Toolchain::find().value().command(false, {});
    command.insert(command.end(), {"-fsyntax-only", "a.cpp"});
    const Outcome outcome = run_tool(command, work.path(), {});
    EXPECT_TRUE(succeeded(outcome)) << header;
    EXPECT_EQ(outcome.err, "") << header;
  }
}

TEST_F(CompilerTest, TellsEveryFileThatWasRead) {
  const Compiled compiled = compile("#include <cstdio>\n" + kTwice);
  const auto holds = [](const std::vector<std::string>& files, const std::string& file) {
    return std::find(files.begin(), files.end(), file) != files.end();
  };
  EXPECT_EQ(compiled.header->inputs[0], (include() / "kit/kit.h").string());
  EXPECT_TRUE(holds(compiled.header->inputs, "/usr/include/stdio.h"));
  EXPECT_EQ(compiled.handlers->inputs[0], (include() / "mjcourse/handlers.cpp").string());
  for (const std::string& file : *compiled.dependencies) {
    EXPECT_TRUE(file.starts_with("/usr/")) << file;
    EXPECT_FALSE(holds(compiled.header->inputs, file)) << file;
  }
}

TEST_F(CompilerTest, TellsWhatARefusedProgramRead) {
  const Compiled compiled = compile("#include <kit/kit.h>\nint main() { return thrice(1); }\n");
  EXPECT_TRUE(compiled.refused());
  EXPECT_EQ(compiled.dependencies.value()[0], (include() / "kit/kit.h").string());
  EXPECT_EQ(compile("#include <kit/none.h>\nint main() {}\n").dependencies, std::nullopt);
}

TEST_F(CompilerTest, MissesAnIncludeThatAnotherProgramHas) {
  ASSERT_TRUE(compile(kTwice).header);
  const Compiled compiled = compile("#include <cstdio>\nint main() { return twice(1); }\n");
  EXPECT_TRUE(compiled.refused());
  EXPECT_EQ(compiled.raw,
            compile("#include <cstdio>\nint main() { return twice(1); }\n", false).raw);
}

TEST_F(CompilerTest, SaysWhatAPlainCompilationSays) {
  write_kit("template <typename T> int half(T x) { return x.half(); }\n");
  const std::string program =
      "#include <kit/kit.h>\nint main() {\n  int unused;\n  return half(3);\n}\n";
  const Compiled plain = compile(program, false);
  const Compiled warm = compile(program);
  EXPECT_EQ(warm.raw, plain.raw);
  EXPECT_EQ(warm.messages.at(0).line, 3);
  EXPECT_EQ(warm.messages.at(1).file, (include() / "kit/kit.h").string());
  const std::string warning = "#include <kit/kit.h>\nint main() { int unused; }\n";
  EXPECT_EQ(compile(warning).raw, compile(warning, false).raw);
  EXPECT_EQ(compile(warning).messages.at(0).text, "unused variable 'unused' [-Wunused-variable]");
}

TEST_F(CompilerTest, SaysWhatThePlainLinkerSays) {
  write_kit("void lost();\ninline int use() { lost(); return 1; }\n");
  for (const char* code : {"lost(); return 0;", "return use();"}) {
    const std::string program = "#include <kit/kit.h>\nint main() { " + std::string(code) + " }\n";
    const Compiled warm = compile(program);
    EXPECT_FALSE(warm.succeeded) << code;
    EXPECT_NE(warm.raw.find("undefined reference to `lost()'"), std::string::npos) << warm.raw;
  }
}

TEST_F(CompilerTest, SeesThatAHeaderChanged) {
  compile(kTwice);
  write_kit("inline int twice(int x) { return 2 * x + 1; }\n");
  EXPECT_TRUE(compile(kTwice).header);
  EXPECT_EQ(exit_code_, 15);
  EXPECT_EQ(headers().size(), 2U);
  write_kit("inline int twice(int x) { return 2 * x; }\n");
  EXPECT_TRUE(compile(kTwice).header);
  EXPECT_EQ(exit_code_, 14);
  EXPECT_EQ(headers().size(), 2U);  // undoing an edit brings the first one again
  write_file(include() / "mjcourse/handlers.cpp", "extern int handled;\nint handled = 8;\n");
  compile(kTwice);
  EXPECT_EQ(exit_code_, 16);
}

TEST_F(CompilerTest, SeesThatAHeaderHidesAnother) {
  write_file(include() / "kit/part.h", "");
  write_kit("#include \"part.h\"\n#include <sysexits.h>\ninline int code() { return EX_OK; }\n");
  const std::string program = "#include <kit/kit.h>\nint main() { return code(); }\n";
  compile(program);
  EXPECT_EQ(exit_code_, 0);
  write_file(include() / "sysexits.h", "#define EX_OK 3\n");
  compile(program);
  EXPECT_EQ(exit_code_, 3);
}

TEST_F(CompilerTest, LeavesATouchedHeaderWarm) {
  compile(kTwice);
  const fs::file_time_type made = fs::last_write_time(headers().at(0));
  fs::last_write_time(include() / "kit/kit.h", fs::file_time_type::clock::now());
  EXPECT_TRUE(compile(kTwice).header);
  EXPECT_EQ(fs::last_write_time(headers().at(0)), made);
}

TEST_F(CompilerTest, DoesNotWarmAHeaderThatTheCompilerDoubts) {
  write_kit("inline int twice(int x) { int unused; return 2 * x; }\n");
  const Compiled compiled = compile(kTwice);
  EXPECT_TRUE(compiled.succeeded);
  EXPECT_FALSE(compiled.header);
  EXPECT_EQ(compiled.messages.at(0).text, "unused variable 'unused' [-Wunused-variable]");
  EXPECT_EQ(compiled.messages.at(0).file, (include() / "kit/kit.h").string());
  write_kit("inline int twice(int x) { return 2 * x; }\n");
  EXPECT_TRUE(compile(kTwice).header);
}

TEST_F(CompilerTest, MakesADamagedHeaderAnew) {
  compile(kTwice);
  fs::resize_file(headers().at(0), 1000);
  EXPECT_EQ(compile(kTwice).raw, "");
  EXPECT_EQ(exit_code_, 14);
  EXPECT_TRUE(compile(kTwice).header);
  EXPECT_GT(fs::file_size(headers().at(0)), 1000U);
}

// Of headers and handlers whatever is left of them, the next program of another process makes them
// new.
TEST_F(CompilerTest, DoesWithoutWhatIsDamaged) {
  const std::string handled =
      "#include <kit/kit.h>\nextern int handled;\nint main() { return twice(handled); }\n";
  const auto files = [&](const std::string& name) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(cache())) {
      if (entry.path().filename() == name) found.push_back(entry.path());
    }
    return found;
  };
  compile(handled);
  const int expected = exit_code_;
  const std::vector<std::function<void()>> damages{
      [&] { fs::resize_file(files("handlers.o").at(0), 1500); },
      [&] { fs::remove(files("handlers.o").at(0)); },
      [&] { fs::remove_all(files("handlers.o").at(0).parent_path()); },
      [&] { fs::remove_all(files("header.pch").at(0).parent_path()); },
      [&] { fs::remove(files("header.pch").at(0)); },
      [&] {
        for (const fs::path& file : files("current")) write_file(file, "");
      },
      [&] {
        for (const fs::path& file : files("current")) write_file(file, "../../elsewhere\n");
      },
      [&] {
        std::string bytes = read_file(files("header.pch").at(0)).value();
        for (std::size_t at = 3000; at < bytes.size(); at += 997) bytes[at] ^= 0x55;
        write_file(files("header.pch").at(0), bytes);
      }};
  for (std::size_t i = 0; i < damages.size(); ++i) {
    damages[i]();
    const Compiled compiled = compile(handled);
    EXPECT_EQ(compiled.raw, "") << i;
    EXPECT_EQ(exit_code_, expected) << i;
    EXPECT_TRUE(compile(handled).header) << i;
    EXPECT_TRUE(compile(handled).handlers) << i;
  }
}

TEST_F(CompilerTest, OptimisesWithoutTheWarmHeader) {
  EXPECT_FALSE(compile(kTwice, true, true).header);
  EXPECT_EQ(exit_code_, 14);
}

TEST_F(CompilerTest, FindsTheToolsHelperHeaderForACourseWithoutOne) {
  fs::remove_all(include() / "mjcourse");
  const fs::path helper = folder_.path() / "tool/include";
  write_file(helper / "mjcourse/mjcourse.hpp",
             "#pragma once\ninline int thrice(int x) { return 3 * x; }\n");
  write_file(helper / "mjcourse/handlers.cpp", "extern int handled;\nint handled = 5;\n");
  const std::string program =
      "#include <mjcourse/mjcourse.hpp>\n#include <kit/kit.h>\n"
      "extern int handled;\nint main() { return thrice(handled) + twice(1); }\n";
  for (const std::optional<fs::path>& kept : {std::optional(cache()), std::optional<fs::path>()}) {
    const Compiler compiler(Toolchain::find().value(), {include(), helper}, kept);
    compiler.make_header({"mjcourse/mjcourse.hpp", "kit/kit.h"}, Warmth::quick);
    const Compiled compiled = compile_with(compiler, program);
    EXPECT_EQ(compiled.raw, "");
    EXPECT_EQ(exit_code_, 17);
    EXPECT_EQ(compiled.header != nullptr, kept.has_value());
  }
  EXPECT_FALSE(compile(program).succeeded);
}

TEST_F(CompilerTest, DoesWithoutACacheThatCannotBeWritten) {
  write_file(cache(), "a file where the folder should be");
  EXPECT_EQ(compile(kTwice).raw, "");
  EXPECT_EQ(exit_code_, 14);
}

TEST_F(CompilerTest, MakesOneHeaderForAllThatWantIt) {
  std::vector<std::jthread> threads;
  std::vector<Compiled> compiled(4);
  // Two processes of two threads each, as far as locks are concerned.
  const Toolchain toolchain = Toolchain::find().value();
  const std::vector<Compiler> compilers{Compiler(toolchain, {include()}, cache()),
                                        Compiler(toolchain, {include()}, cache())};
  for (std::size_t i = 0; i < compiled.size(); ++i) {
    threads.emplace_back([&, i] {
      const TemporaryFolder work;
      write_file(work.path() / "a.cpp", kTwice);
      compilers[i % 2].make_header({"kit/kit.h"}, Warmth::thorough);
      compiled[i] = compilers[i % 2].compile(work.path() / "a.cpp", work.path() / "a", work.path());
    });
  }
  threads.clear();
  for (const Compiled& one : compiled) EXPECT_TRUE(one.header && one.succeeded);
  EXPECT_EQ(headers().size(), 1U);
}

}  // namespace
}  // namespace mjcourse
