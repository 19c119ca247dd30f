#include "base/spool.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/parallel.h"

namespace mjcourse {
namespace {

TEST(Spool, GivesBackEachPieceWhicheverThreadPutIt) {
  Spool spool;
  std::vector<Spool::Piece> pieces(200);
  const auto text_of = [](std::size_t index) {
    return std::string(index * 37, static_cast<char>('a' + index % 26));
  };
  for_each_index(pieces.size(), 2, [&](std::size_t index, std::size_t) {
    pieces[index] = spool.put(text_of(index));
  });
  for (std::size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(spool.get(pieces[i]), text_of(i));
}

}  // namespace
}  // namespace mjcourse
