#include "physics/model_error.h"

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

ModelError explain(const std::string& answer, const std::string& mjcf = "") {
  return explain_load_error(answer, "models/arm.xml", mjcf);
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

TEST(ModelError, NamesTheIncludedFileAtFault) {
  const std::string answer =
      "XML Error: Include error: 'XML parse error 14:\nError=XML_ERROR_MISMATCHED_ELEMENT "
      "ErrorID=14 (0xe) Line number=3: XMLElement name=geom\n'\nElement 'include', line 3\n";
  const std::string mjcf =
      "<mujoco>\n  <include file=\"fine.xml\"/>\n  <include\n   file='parts/hand.xml'/>\n</mujoco>";
  EXPECT_EQ(explain(answer, mjcf), (ModelError{"models/parts/hand.xml", 3, 0,
                                               "not well-formed XML: mismatched element 'geom'"}));
  // Without the text there is no telling which include it was.
  EXPECT_EQ(explain(answer), (ModelError{"models/arm.xml", 3, 0,
                                         "an included file: not well-formed XML: mismatched "
                                         "element 'geom'"}));
}

TEST(ModelError, BlamesTheIncludeForAMissingFile) {
  EXPECT_EQ(
      explain("XML Error: Include error: 'XML parse error 3:\nError=XML_ERROR_FILE_NOT_FOUND "
              "ErrorID=3 (0x3) Line number=0: filename=gone.xml\n'\nElement 'include', line 2",
              "<mujoco>\n<include file='gone.xml'/></mujoco>"),
      (ModelError{"models/arm.xml", 2, 0, "included file 'gone.xml': file not found"}));
}

TEST(ModelError, SaysThatALinelessElementMayBeInAnInclude) {
  EXPECT_EQ(explain("XML Error: bad\nElement 'geom', line 0\n", "<mujoco><include file='a'/>"),
            (ModelError{"models/arm.xml", 0, 0,
                        "element 'geom': bad (in a file that this one includes)"}));
}

}  // namespace
}  // namespace mjcourse
