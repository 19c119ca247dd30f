#include "evaluate/context/shown_program.h"

#include <gtest/gtest.h>

#include "course/course_of.h"
#include "evaluate/programs/region.h"

namespace mjcourse {
namespace {

std::string program_fence(const std::string& file, const std::string& code = "") {
  return "```cpp file=examples/" + file + "\n" + code + "```\n\n";
}

// What is shown of examples/a.cpp by a course of these two lessons.
class Shown {
 public:
  Shown(const std::string& x, const std::string& y) : course_(course_of(x, y)) {
    EXPECT_EQ(course_.mistakes(), "");
    shown_ = shown_programs(course_.course.value());
  }
  const ShownProgram* operator->() const { return &shown_.at("examples/a.cpp"); }
  const ShownProgram& operator*() const { return shown_.at("examples/a.cpp"); }

 private:
  CourseOf course_;
  ShownPrograms shown_;
};

TEST(ShownProgram, IsGatheredFromAllLessons) {
  const Shown shown(program_fence("a.cpp") + program_fence("b.cpp") + program_fence("a.cpp#r"),
                    program_fence("a.cpp", "x;\n"));
  EXPECT_EQ(shown->whole.size(), 2u);
  EXPECT_EQ(shown->regions.size(), 1u);
  ASSERT_NE(shown->text(), nullptr);
  EXPECT_EQ(shown->text()->code.text, "x;\n");
  EXPECT_EQ(Shown(program_fence("a.cpp"), program_fence("a.cpp#r", "x;\n"))->text(), nullptr);
}

TEST(ShownProgram, ContradictsItselfWhereTwoFencesDiffer) {
  const std::string x = program_fence("a.cpp", "x;\n"), y = program_fence("a.cpp", "y;\n");
  EXPECT_TRUE(Shown(x, y)->contradicts_itself());
  EXPECT_FALSE(Shown(x, x + program_fence("a.cpp"))->contradicts_itself());
  EXPECT_TRUE(Shown(program_fence("a.cpp#r", "x;\n"), program_fence("a.cpp#r", "y;\n"))
                  ->contradicts_itself());
  EXPECT_FALSE(Shown(program_fence("a.cpp#r", "x;\n"), program_fence("a.cpp#s", "y;\n"))
                   ->contradicts_itself());
}

TEST(ShownProgram, HasTheLinesOfItsRegionsFences) {
  const Shown shown(program_fence("a.cpp#r", "x;\n"), program_fence("a.cpp#missing", "y;\n"));
  EXPECT_EQ(with_shown_regions("  // #region r\n  old;\n  // #endregion\n", *shown),
            "  // #region r\n  x;\n  // #endregion\n");
  EXPECT_EQ(with_shown_regions("// #region r\nnever closed;\n", *shown),
            "// #region r\nnever closed;\n");
}

}  // namespace
}  // namespace mjcourse
