#include "preview/quick_store.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

// Counts how often it is asked.
class Counting : public MemoryStore {
 public:
  std::optional<std::string> get(const std::string& name) override {
    ++asked;
    return MemoryStore::get(name);
  }
  int asked = 0;
};

TEST(QuickStore, AsksOnceForWhatIsSmall) {
  Counting slow;
  slow.put("ac/1", "result");
  slow.put("cas/1", "picture");
  QuickStore store(&slow);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(store.get("ac/1"), "result");
    EXPECT_EQ(store.get("cas/1"), "picture");
  }
  EXPECT_EQ(slow.asked, 1 + 3);
}

TEST(QuickStore, AsksAgainForWhatWasNotThere) {
  Counting slow;
  QuickStore store(&slow);
  EXPECT_EQ(store.get("ac/1"), std::nullopt);
  slow.put("ac/1", "of another process");
  EXPECT_EQ(store.get("ac/1"), "of another process");
}

TEST(QuickStore, HandsOnWhatIsPut) {
  Counting slow;
  QuickStore store(&slow);
  EXPECT_TRUE(store.put("ac/1", "first"));
  EXPECT_TRUE(store.put("ac/1", "second"));
  EXPECT_EQ(store.get("ac/1"), "second");
  EXPECT_EQ(slow.get("ac/1"), "second");
}

TEST(QuickStore, KeepsAllWithoutAnother) {
  QuickStore store(nullptr);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  EXPECT_EQ(store.get("cas/1"), "picture");
  EXPECT_EQ(store.get("cas/2"), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
