#include "session/write_behind_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "memory_store.h"

namespace mjcourse {
namespace {

// Counts how often it is asked.
class Counting : public MemoryStore {
 public:
  std::optional<Stored> find(const std::string& name) override {
    ++asked;
    return MemoryStore::find(name);
  }
  int asked = 0;
};

TEST(WriteBehindStore, AsksOnceForWhatIsSmall) {
  Counting slow;
  slow.put("ac/1", "result");
  slow.put("cas/1", "picture");
  WriteBehindStore store(&slow);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(store.get("ac/1"), "result");
    EXPECT_EQ(store.get("cas/1"), "picture");
  }
  EXPECT_EQ(slow.asked, 1 + 3);
}

TEST(WriteBehindStore, AsksAgainForWhatWasNotThere) {
  Counting slow;
  WriteBehindStore store(&slow);
  EXPECT_EQ(store.get("ac/1"), std::nullopt);
  slow.put("ac/1", "of another process");
  EXPECT_EQ(store.get("ac/1"), "of another process");
}

TEST(WriteBehindStore, HandsOnWhatIsPut) {
  Counting slow;
  {
    WriteBehindStore store(&slow);
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
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override {
    released.wait(false);
    return !full && MemoryStore::keep(name, bytes, origin);
  }
  std::atomic<bool> released = false;
  bool full = false;
};

TEST(WriteBehindStore, DoesNotWaitForTheOther) {
  Waiting slow;
  WriteBehindStore store(&slow);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  EXPECT_TRUE(store.put("cas/2", "another"));
  EXPECT_EQ(store.get("cas/1"), "picture");
  EXPECT_EQ(store.get("cas/2"), "another");
  EXPECT_EQ(slow.get("cas/1"), std::nullopt);
  slow.released = true;
  slow.released.notify_all();
}

TEST(WriteBehindStore, KnowsWhereAllIsFrom) {
  MemoryStore slow;
  {
    WriteBehindStore store(&slow);
    store.keep("ac/1", "result", Origin::unsigned_one());
    EXPECT_EQ(store.find("ac/1")->origin, Origin::unsigned_one());
  }
  EXPECT_EQ(slow.find("ac/1")->origin, Origin::unsigned_one());
  EXPECT_EQ(WriteBehindStore(&slow).find("ac/1")->origin, Origin::unsigned_one());
}

TEST(WriteBehindStore, HasWhatTheOtherCannotKeep) {
  Waiting slow;
  slow.full = slow.released = true;
  WriteBehindStore store(&slow);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(store.get("cas/1"), "picture");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

TEST(WriteBehindStore, KeepsAllWithoutAnother) {
  WriteBehindStore store(nullptr);
  EXPECT_TRUE(store.put("cas/1", "picture"));
  EXPECT_EQ(store.get("cas/1"), "picture");
  EXPECT_EQ(store.get("cas/2"), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
