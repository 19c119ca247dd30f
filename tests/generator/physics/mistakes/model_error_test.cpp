#include "physics/mistakes/model_error.h"

#include <gtest/gtest.h>

#include <ostream>

namespace mjcourse {

// The cure is looked at on its own.
static bool operator==(const ModelError& a, const ModelError& b) {
  return a.file == b.file && a.line == b.line && a.column == b.column && a.message == b.message;
}

static void PrintTo(const ModelError& error, std::ostream* out) {
  *out << error.file << ':' << error.line << ':' << error.column << ": " << error.message;
}

namespace {

ModelError explain(const std::string& answer) {
  return explain_load_error(answer, "models/arm.xml");
}

TEST(ModelError, ReadsTheXmlParsersSpelling) {
  EXPECT_EQ(explain("XML parse error 14:\nError=XML_ERROR_MISMATCHED_ELEMENT ErrorID=14 (0xe) "
                    "Line number=3: XMLElement name=geom\n"),
            (ModelError{"models/arm.xml", 3, 0, "not well-formed XML: mismatched element 'geom'"}));
}

TEST(ModelError, ReadsTheSchemasSpelling) {
  EXPECT_EQ(
      explain("XML Error: Schema violation: unrecognized attribute: 'sizee'\n\n"
              "Element 'geom', line 5, column 3\n"),
      (ModelError{"models/arm.xml", 5, 3, "element 'geom': unrecognized attribute: 'sizee'"}));
  EXPECT_EQ(
      explain("XML Error: problem reading attribute 'size'\nElement 'geom', line 5\n"),
      (ModelError{"models/arm.xml", 5, 0, "element 'geom': problem reading attribute 'size'"}));
}

TEST(ModelError, IsOneLineWhateverNamesAreInIt) {
  EXPECT_EQ(explain("XML Error: unrecognized element\nElement 'a\nb', line 5, column 3\n").message,
            "element 'a b': unrecognized element");
  EXPECT_EQ(explain("XML parse error 14:\nError=XML_ERROR_MISMATCHED\nELEMENT ErrorID=14 (0xe) "
                    "Line number=3:\n")
                .message,
            "not well-formed XML: mismatched element");
}

TEST(ModelError, ReadsTheCompilersSpelling) {
  EXPECT_EQ(explain("Error: mass is too small\nObject name = b, id = 1, line = 7, column = -1"),
            (ModelError{"models/arm.xml", 7, 0, "object 'b': mass is too small"}));
  EXPECT_EQ(explain("Error: mass is too small\nObject name = , id = 1, line = 7, column = 2"),
            (ModelError{"models/arm.xml", 7, 2, "mass is too small"}));
  EXPECT_EQ(explain("Error: key 0: invalid qpos size, expected length 7\nObject name = , id = 0"),
            (ModelError{"models/arm.xml", 0, 0, "key 0: invalid qpos size, expected length 7"}));
}

TEST(ModelError, SuggestsTheWordThatWasMeant) {
  const std::string place = "\n\nElement 'geom', line 5\n";
  const std::string schema = "XML Error: Schema violation: unrecognized ";
  EXPECT_EQ(explain(schema + "attribute: 'sizee'" + place).cure, "did you mean `size`?");
  EXPECT_EQ(explain(schema + "attribute: 'wavelength'" + place).cure, "");
  EXPECT_EQ(explain(schema + "element\n\nElement 'gem', line 5\n").cure, "did you mean `geom`?");
  EXPECT_EQ(explain("XML Error: problem reading attribute 'size'" + place).cure, "");
}

TEST(ModelError, KeepsAnAnswerOfAnyOtherShapeOnOneLine) {
  EXPECT_EQ(explain("Error: engine error: Stack overflow"),
            (ModelError{"models/arm.xml", 0, 0, "Stack overflow"}));
  EXPECT_EQ(explain("Error: did not converge:\n  eval (1, 2)\n"),
            (ModelError{"models/arm.xml", 0, 0, "did not converge: eval (1, 2)"}));
  EXPECT_EQ(explain("XML root element not found"),
            (ModelError{"models/arm.xml", 0, 0, "XML root element not found"}));
}

TEST(ModelError, TakesALineInAMessageForNoLineNumber) {
  EXPECT_EQ(
      explain("Error: line 9 is a name\nObject name = line = 8, id = 1, line = 7, column = 2"),
      (ModelError{"models/arm.xml", 7, 2, "object 'line = 8': line 9 is a name"}));
}

TEST(ModelError, SaysWhichVersionHasAWord) {
  const std::string schema = "XML Error: Schema violation: unrecognized ";
  const auto cure = [](const std::string& answer) { return explain(answer).cure; };
  EXPECT_EQ(cure(schema + "attribute: 'memory'\n\nElement 'size', line 2\n"),
            "MuJoCo has `memory` from version 2.3.0 on; this is MuJoCo 2.2.2");
  EXPECT_EQ(cure(schema + "element\n\nElement 'frame', line 2\n"),
            "MuJoCo has `frame` from version 3.1.0 on; this is MuJoCo 2.2.2");
  EXPECT_EQ(cure("XML Error: invalid keyword: 'implicitfast'\nElement 'option', line 1\n"),
            "MuJoCo has `implicitfast` from version 2.3.3 on; this is MuJoCo 2.2.2");
  EXPECT_EQ(cure("XML Error: invalid keyword: 'implicitfast'\nElement 'geom', line 1\n"), "");
}

}  // namespace
}  // namespace mjcourse
