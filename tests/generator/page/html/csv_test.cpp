#include "page/html/csv.h"

#include <gtest/gtest.h>

namespace mjcourse {

TEST(Csv, HasALineForTheNamesAndOneForEachRow) {
  EXPECT_EQ(csv_of({{"time", {0, 0.1}}, {"e", {-1e-20, 1.0 / 3}}}),
            "time,e\r\n0,-1e-20\r\n0.1,0.3333333333333333\r\n");
}

TEST(Csv, QuotesWhatWouldBeTakenForAnEnd) {
  EXPECT_EQ(csv_of({{"a, b", {1}}, {"\"c\"", {2}}}), "\"a, b\",\"\"\"c\"\"\"\r\n1,2\r\n");
}

}  // namespace mjcourse
