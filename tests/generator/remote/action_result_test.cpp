#include "remote/action_result.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(ActionResult, IsAProtocolBuffer) {
  // Field 5, of a length; protoc --decode has it the same way.
  EXPECT_EQ(action_result("abc"),
            "\x2a\x03"
            "abc");
  EXPECT_EQ(action_result(std::string(300, 'x')).substr(0, 3), "\x2a\xac\x02");
}

TEST(ActionResult, GivesItsOutput) {
  for (const std::size_t size : {0u, 1u, 127u, 128u, 100'000u}) {
    const std::string output(size, 'y');
    EXPECT_EQ(outputs_of(action_result(output))->output, output);
    EXPECT_EQ(outputs_of(action_result(output))->error, "");
    EXPECT_EQ(outputs_of(action_result("x", output))->error, output);
  }
}

TEST(ActionResult, LeavesOtherFieldsAlone) {
  // exit_code (4, a varint), stdout_raw, and an execution_metadata (9, of a length).
  const std::string other = "\x20\x07" + action_result("abc") + "\x4a\x02zz";
  EXPECT_EQ(outputs_of(other)->output, "abc");
  EXPECT_FALSE(outputs_of("\x20\x07"));
  EXPECT_FALSE(outputs_of(""));
}

TEST(ActionResult, RefusesWhatIsNone) {
  const std::string whole = action_result("abcdef");
  for (std::size_t size = 1; size < whole.size(); ++size) {
    EXPECT_FALSE(outputs_of(whole.substr(0, size))) << size;
  }
  EXPECT_FALSE(outputs_of("<html></html>"));
  EXPECT_FALSE(outputs_of(std::string(20, '\xff')));
}

}  // namespace
}  // namespace mjcourse
