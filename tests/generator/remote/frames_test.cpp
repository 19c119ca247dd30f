#include "remote/frames.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mjcourse {
namespace {

TEST(FrameReader, TakesWholeMessagesOutOfPieces) {
  const std::string bytes = frame_of("1 GET ac/7", "") + frame_of("2 PUT cas/7", "a\nb\0c");
  FrameReader frames;
  std::vector<std::string> heads, bodies;
  for (const char c : bytes) {
    frames.add({&c, 1});
    while (auto message = frames.next()) {
      heads.push_back(message->head);
      bodies.push_back(message->body);
    }
  }
  EXPECT_EQ(heads, (std::vector<std::string>{"1 GET ac/7", "2 PUT cas/7"}));
  EXPECT_EQ(bodies, (std::vector<std::string>{"", "a\nb"}));
}

TEST(FrameReader, RefusesWhatIsTooLarge) {
  FrameReader frames;
  frames.add(std::string(8, '\x7f'));
  EXPECT_THROW(frames.next(), std::length_error);
}

}  // namespace
}  // namespace mjcourse
