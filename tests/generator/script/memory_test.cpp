#include "script/memory.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

const std::string* no_answer = nullptr;

TEST(Memory, KnowsWhatItWasTold) {
  Memory memory(1000);
  EXPECT_EQ(memory.find("a"), no_answer);
  memory.keep("a", "1");
  memory.keep("b", "2");
  ASSERT_NE(memory.find("a"), no_answer);
  EXPECT_EQ(*memory.find("a"), "1");
  EXPECT_EQ(*memory.find("b"), "2");
}

TEST(Memory, DoesNotKeepWhatIsLarge) {
  Memory memory(1000);
  memory.keep("question", "and a long answer");
  EXPECT_EQ(memory.find("question"), no_answer);
}

TEST(Memory, BeginsAnewWhereItIsFull) {
  Memory memory(1000);
  for (char letter = 'a'; letter <= 'z'; ++letter) {
    for (int i = 10; i < 30; ++i) memory.keep(letter + std::to_string(i), "x");
  }
  EXPECT_EQ(memory.find("a10"), no_answer);
  EXPECT_NE(memory.find("z29"), no_answer);
}

}  // namespace
}  // namespace mjcourse
