#include "evaluate/programs/quoted_includes.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Names = std::vector<std::string>;

TEST(QuotedIncludes, AreNamedInTheirOrder) {
  EXPECT_EQ(
      quoted_includes("#include <cstdio>\n#include \"b.h\"\n\t# include\t\"sub/a.h\" // why\n"),
      (Names{"b.h", "sub/a.h"}));
}

TEST(QuotedIncludes, AreAlsoThoseThatAConditionLeavesOut) {
  EXPECT_EQ(quoted_includes("#if 0\n#include \"a.h\"\n#endif\n"), Names{"a.h"});
}

TEST(QuotedIncludes, AreNoOtherLines) {
  EXPECT_EQ(quoted_includes("// #include \"a.h\"\nint x; #include \"b.h\"\n#include \"c.h\n"
                            "#include_next \"d.h\"\n#include NAME\n\"e.h\"\n#include \"\"\n"),
            Names());
}

TEST(QuotedIncludes, OfLinesThatEndAsOnWindowsAreTheSame) {
  EXPECT_EQ(quoted_includes("#include \"a.h\"\r\n#include \"b.h\"\r\n"), (Names{"a.h", "b.h"}));
}

}  // namespace
}  // namespace mjcourse
