#include "session/quick_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

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
  {
    QuickStore store(&slow);
    EXPECT_TRUE(store.put("ac/1", "first"));
    EXPECT_TRUE(store.put("ac/1", "second"));
    EXPECT_TRUE(store.put("cas/1", "picture"));
    EXPECT_EQ(store.get("ac/1"), "second");
    EXPECT_EQ(store.get("cas/1"), "picture");
  }
  EXPECT_EQ(slow.get("ac/1"), "second");
  EXPECT_EQ(slow.get("cas/1"), "picture");
}

// As one whose disk is slow.
class Waiting : public MemoryStore {
 public:
  bool put(const std::string& name, std::string_view bytes) override {
    released.wait(false);
    return !full && MemoryStore::put(name, bytes);
  }
  std::atomic<bool> released = false;
  bool full = false;
};

TEST(QuickStore, DoesNotWaitForTheOther) {
  Waiting slow;
  QuickStore store(&slow);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  EXPECT_TRUE(store.put("cas/2", "another"));
  EXPECT_EQ(store.get("cas/1"), "picture");
  EXPECT_EQ(store.get("cas/2"), "another");
  EXPECT_EQ(slow.get("cas/1"), std::nullopt);
  slow.released = true;
  slow.released.notify_all();
}

TEST(QuickStore, HasWhatTheOtherCannotKeep) {
  Waiting slow;
  slow.full = slow.released = true;
  QuickStore store(&slow);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(store.get("cas/1"), "picture");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(QuickStore, KeepsAllWithoutAnother) {
  QuickStore store(nullptr);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  EXPECT_EQ(store.get("cas/1"), "picture");
  EXPECT_EQ(store.get("cas/2"), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
