#include "lsp/messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace mjcourse {
namespace {

TEST(Messages, AreReadOneByOne) {
  std::istringstream in(
      "Content-Length: 2\r\n\r\n{}"
      "content-length:3\r\nContent-Type: application/json\r\n\r\n[1]");
  EXPECT_EQ(read_message(in), "{}");
  EXPECT_EQ(read_message(in), "[1]");
  EXPECT_EQ(read_message(in), std::nullopt);
}

TEST(Messages, AHeaderWithoutALengthIsPassedOver) {
  std::istringstream in("Content-Type: x\r\n\r\nnonsense\r\n\r\nContent-Length: 4\r\n\r\ntrue");
  EXPECT_EQ(read_message(in), "true");
}

TEST(Messages, EndWhereTheyCannotBeTold) {
  for (const std::string text :
       {"Content-Length: 5\r\n\r\n{}", "Content-Length: 99999999999\r\n\r\n",
        "Content-Length: -1\r\n\r\n", "Content-Length", ""}) {
    std::istringstream in(text);
    EXPECT_EQ(read_message(in), std::nullopt) << text;
  }
  std::istringstream endless(std::string(100000, 'x'));
  EXPECT_EQ(read_message(endless), std::nullopt);
}

TEST(Messages, NestNoDeeperThanAnyEditors) {
  const auto nested = [](int depth) {
    const auto size = static_cast<std::size_t>(depth);
    return std::string(size, '[') + std::string(size, ']');
  };
  EXPECT_EQ(parse_message(nested(kDeepestMessage)).dump(), nested(kDeepestMessage));
  EXPECT_TRUE(parse_message(nested(kDeepestMessage + 1)).is_discarded());
  EXPECT_TRUE(parse_message("{\"id\":" + nested(300000) + "}").is_discarded());
  EXPECT_TRUE(parse_message("{\"id\":").is_discarded());
}

TEST(Messages, WhatIsWrittenCanBeRead) {
  std::stringstream both;
  write_message(both, "{\"ö\":1}");
  EXPECT_EQ(both.str(), "Content-Length: 8\r\n\r\n{\"ö\":1}");
  EXPECT_EQ(read_message(both), "{\"ö\":1}");
}

}  // namespace
}  // namespace mjcourse
