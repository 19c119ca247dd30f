#include "lesson/syntax/offsets.h"

#include <gtest/gtest.h>

#include <vector>

namespace mjcourse {
namespace {

std::vector<std::size_t> all(const Offsets& offsets) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < offsets.size(); ++i) list.push_back(offsets[i]);
  return list;
}

using List = std::vector<std::size_t>;

Offsets offsets_of(const List& list) {
  Offsets offsets;
  for (const std::size_t offset : list) offsets.push_back(offset);
  return offsets;
}

TEST(Offsets, OfBytesSideBySideHaveOneForTheEnd) {
  EXPECT_EQ(all(Offsets::side_by_side(7, 10)), (List{7, 8, 9, 10}));
  EXPECT_EQ(all(Offsets::side_by_side(7, 7)), (List{7}));
}

TEST(Offsets, KeepWhateverIsPushed) {
  for (const List& list : {List{}, List{3}, List{3, 3, 3}, List{3, 4, 4, 4, 5, 6}, List{9, 2, 3, 1},
                           List{3, 3, 4, 5}, List{0, 1, 1, 2, 2, 3}}) {
    EXPECT_EQ(all(offsets_of(list)), list);
  }
}

TEST(Offsets, OfOneByteManyTimes) {
  Offsets offsets = Offsets::side_by_side(1, 2);
  offsets.append_still(3, 2);
  offsets.append_still(0, 9);
  offsets.push_back(3);
  offsets.append_still(1, 4);
  EXPECT_EQ(all(offsets), (List{1, 2, 2, 2, 2, 3, 4}));
  EXPECT_EQ(offsets.back(), 4U);
}

TEST(Offsets, GiveEveryPart) {
  const List list{5, 6, 7, 7, 7, 7, 20, 21, 3};
  const Offsets offsets = offsets_of(list);
  for (std::size_t begin = 0; begin <= list.size(); ++begin) {
    for (std::size_t end = begin; end <= list.size(); ++end) {
      List expected{6};
      expected.insert(expected.end(), list.begin() + static_cast<std::ptrdiff_t>(begin),
                      list.begin() + static_cast<std::ptrdiff_t>(end));
      Offsets part = offsets_of({6});
      part.append(offsets, begin, end);
      EXPECT_EQ(all(part), expected);
    }
  }
}

}  // namespace
}  // namespace mjcourse
