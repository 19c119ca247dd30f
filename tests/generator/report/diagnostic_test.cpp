#include "report/diagnostic.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

std::string shown(const Place& place) {
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + "+" +
         std::to_string(place.width) + " " + place.excerpt;
}

const SourceText kSource("a.md", "first\n→ second line\r\nthird");

TEST(PlaceOf, CountsInCharacters) {
  EXPECT_EQ(shown(place_of(kSource, {0, 5})), "a.md:1:1+5 first");
  EXPECT_EQ(shown(place_of(kSource, {10, 16})), "a.md:2:3+6 → second line");
  EXPECT_EQ(shown(place_of(kSource, {6, 9})), "a.md:2:1+1 → second line");
}

TEST(PlaceOf, CutsAtTheEndOfTheFirstLine) {
  EXPECT_EQ(shown(place_of(kSource, {17, 28})), "a.md:2:10+4 → second line");
}

TEST(PlaceOf, IsNeverWithoutWidth) {
  EXPECT_EQ(shown(place_of(kSource, {2, 2})), "a.md:1:3+1 first");
  EXPECT_EQ(shown(place_of(kSource, {3, 1})), "a.md:1:4+1 first");
}

TEST(PlaceOf, StaysInTheText) {
  EXPECT_EQ(shown(place_of(kSource, {1000, 2000})), "a.md:3:6+1 third");
}

TEST(Diagnostic, IsOneLineOfText) {
  const Diagnostic error = error_at({}, "E-a", "no \"a\nb\x1b[2J\"", "did you mean \"a\tb\"?");
  EXPECT_EQ(error.message, "no \"a\\nb\\x1b[2J\"");
  EXPECT_EQ(error.cure, "did you mean \"a\\tb\"?");
}

TEST(Concerns, IsAboutItsFileAndThoseOfItsNotes) {
  Diagnostic diagnostic = error_at({"models/a.xml", 3, 1, 1, ""}, "E-a", "wrong");
  diagnostic.notes = {{"it stands there", {}}, {"this uses it", {"content/1.1-a.md", 7, 1, 1, ""}}};
  EXPECT_TRUE(concerns(diagnostic, "models/a.xml"));
  EXPECT_TRUE(concerns(diagnostic, "content/1.1-a.md"));
  EXPECT_FALSE(concerns(diagnostic, "content/1.1"));
}

TEST(Diagnostic, QuotesNoMoreThanAReaderReads) {
  const std::string long_word = "é" + std::string(100'000, 'x') + "é";
  const Diagnostic error = error_at({}, "E-a", "no `" + long_word + "`");
  EXPECT_EQ(error.message, "no `é" + std::string(994, 'x') + " … " + std::string(997, 'x') + "é`");
}

// The same line under ten thousand mistakes would fill the memory.
TEST(PlaceOf, HasOfALongLineWhatIsAroundIt) {
  const SourceText source("a.md",
                          "ab\n" + std::string(5'000, 'x') + "é!" + std::string(5'000, 'y'));
  const Place place = place_of(source, {5'005, 5'006});
  EXPECT_EQ(place.line, 2);
  EXPECT_EQ(place.column, 5'002);
  EXPECT_EQ(place.excerpt_column, 4'603);
  EXPECT_EQ(place.excerpt, std::string(398, 'x') + "é!" + std::string(399, 'y'));
}

}  // namespace
}  // namespace mjcourse
