#include "cli/tally_text.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(TallyText, NamesWhatThereIs) {
  Tally tally;
  EXPECT_EQ(tally_text(tally), "");
  tally.programs = 1;
  tally.in_page = 1;
  tally.outputs = 2;
  tally.unchecked = 1;
  EXPECT_EQ(tally_text(tally),
            "1 program run, 1 in the page, 2 outputs compared, 1 listing unchecked");
  EXPECT_EQ(outcome_text(tally, 3), tally_text(tally));
}

TEST(TallyText, TellsNothingVerifiedFromNothingToVerify) {
  EXPECT_EQ(outcome_text({}, 0), "nothing to verify");
  EXPECT_EQ(outcome_text({}, 1), "nothing verified");
}

}  // namespace
}  // namespace mjcourse
