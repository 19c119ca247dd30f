#include "page/program_folder.h"

#include <gtest/gtest.h>

#include "findings/snippet_program.h"
#include "page/site_data.h"
#include "reading_of.h"

namespace mjcourse {
namespace {

class ProgramFolder : public testing::Test {
 protected:
  // The folder of the one program of a lesson with this fence, which was made of `files`.
  std::map<std::string, std::string> folder_of(const std::string& fence,
                                               std::vector<std::string> files) {
    course_.title = "Course";
    course_.lessons.clear();
    course_.add(std::move(reading_of(fence).lesson.value()));
    const Lesson& lesson = course_.lessons[0];
    const ExampleResult result{"", printed_, {}, 0, std::move(files)};
    const SiteData site{course_, evaluation_, course_files_, assets_, {}, {}};
    return program_folder({std::get<Example>(lesson.blocks.at(0)), result, lesson}, site);
  }

  const MemoryFiles course_files_{
      {{"examples/a.cpp", "int main() {}\n"},
       {"examples/draws.cpp", "#include <GL/osmesa.h>\nint main() {}\n"},
       {"examples/sub/b c.cpp", "int main() {}\n"},
       {"examples/sub/beside.h", "// beside\n"},
       {"examples/include/own.hpp", "// own\n"},
       {"models/m/x.xml", "<mujoco/>\n"}}};
  const MemoryFiles assets_{{{"examples/include/mjcourse/handlers.cpp", "// tool\n"},
                             {"examples/include/own.hpp", "// hidden\n"}}};
  std::string printed_;
  Course course_;
  Evaluation evaluation_;
};

TEST_F(ProgramFolder, HasWhatTheProgramWasMadeOfAndOpened) {
  const auto files = folder_of(
      "```cpp file=examples/a.cpp\n```\n",
      {"examples/include/mjcourse/handlers.cpp", "examples/include/own.hpp", "models/m/x.xml"});
  std::string names;
  for (const auto& [path, bytes] : files) names += path + "\n";
  EXPECT_EQ(names,
            "a/CMakeLists.txt\na/README.txt\na/a.cpp\na/include/mjcourse/handlers.cpp\n"
            "a/include/own.hpp\na/models/m/x.xml\n");
  EXPECT_EQ(files.at("a/include/own.hpp"), "// own\n") << "the course's goes before the tool's";
  EXPECT_EQ(files.at("a/include/mjcourse/handlers.cpp"), "// tool\n");
  EXPECT_NE(files.at("a/CMakeLists.txt")
                .find("add_executable(program \"a.cpp\" \"include/mjcourse/handlers.cpp\")\n"),
            std::string::npos);
}

TEST_F(ProgramFolder, IsOfASnippetToo) {
  Lesson lesson =
      std::move(reading_of("```cpp snippet model=m/x\na;\n```\n\n```cpp snippet model=m/x native\n"
                           "b;\n```\n")
                    .lesson.value());
  lesson.number = "A.3";
  const Example program = snippet_program(lesson, 1);
  EXPECT_EQ(program.file.text, "snippets/snippet_A_3_2.cpp");
  EXPECT_EQ(program.native, "native only");
  const ExampleResult result{"whole\n", "", {}, 0, {"models/m/x.xml"}};
  const SiteData site{course_, evaluation_, course_files_, assets_, {}, {}};
  const auto files = program_folder({program, result, lesson, result.code}, site);
  EXPECT_EQ(files.at("snippet_A_3_2/snippet_A_3_2.cpp"), "whole\n");
  EXPECT_TRUE(files.contains("snippet_A_3_2/models/m/x.xml"));
}

TEST_F(ProgramFolder, SaysWhatTheProgramPrints) {
  printed_ = "1\n";
  const auto files = folder_of("```cpp file=examples/a.cpp\n```\n", {});
  EXPECT_EQ(files.at("a/expected-output.txt"), "1\n");
}

TEST_F(ProgramFolder, HasBesideTheProgramWhatLiesBesideIt) {
  const auto files = folder_of("```cpp file=\"examples/sub/b c.cpp\"\n```\n",
                               {"examples/include/own.hpp", "examples/sub/beside.h"});
  EXPECT_EQ(files.at("b c/beside.h"), "// beside\n");
  EXPECT_EQ(files.at("b c/include/own.hpp"), "// own\n");
}

TEST_F(ProgramFolder, SaysInThreeLinesWhatItIs) {
  const auto files =
      folder_of("```cpp file=\"examples/sub/b c.cpp\" args=\"1 a*b it's\"\n```\n", {});
  ASSERT_TRUE(files.contains("b c/README.txt")) << files.begin()->first;
  const std::string& text = files.at("b c/README.txt");
  EXPECT_NE(text.find("\nLesson 1.1: T\ncmake -S . -B build && cmake --build build, then "
                      "'build/b c' 1 'a*b' 'it'\\''s'\n"),
            std::string::npos)
      << text;
  EXPECT_TRUE(text.starts_with("b c.cpp: a program of “Course”")) << text;
  EXPECT_EQ(files.size(), 3u);
}

TEST_F(ProgramFolder, FindsOSMesaForAProgramThatDraws) {
  const auto plain = folder_of("```cpp file=examples/a.cpp\n```\n", {});
  EXPECT_EQ(plain.at("a/CMakeLists.txt").find("OSMesa"), std::string::npos);
  const auto files = folder_of("```cpp file=examples/draws.cpp\n```\n", {});
  const std::string& cmake = files.at("draws/CMakeLists.txt");
  EXPECT_NE(cmake.find("find_library(LIB_OSMesa OSMesa REQUIRED)\n"), std::string::npos) << cmake;
  EXPECT_NE(cmake.find("PRIVATE ${LIB_mujoco} ${LIB_OSMesa} Eigen3::Eigen)\n"), std::string::npos)
      << cmake;
  EXPECT_NE(files.at("draws/README.txt").find("libosmesa6-dev"), std::string::npos);
}

TEST_F(ProgramFolder, FailsWhereAFileIsGone) {
  EXPECT_THROW(folder_of("```cpp file=examples/a.cpp\n```\n", {"models/gone.xml"}),
               std::runtime_error);
}

}  // namespace
}  // namespace mjcourse
