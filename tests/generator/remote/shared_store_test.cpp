#include "remote/shared_store.h"

#include <gtest/gtest.h>

#include "memory_store.h"

namespace mjcourse {
namespace {

class Full : public MemoryStore {
 public:
  bool put(const std::string&, std::string_view) override { return false; }
};

TEST(SharedStore, TakesFromTheRemoteStoreWhatTheDiskDoesNotHave) {
  MemoryStore disk, remote;
  remote.put("ac/1", "of another machine");
  disk.put("ac/2", "of this one");
  SharedStore store(disk, remote, SharedStore::Sends::puts);
  EXPECT_EQ(store.get("ac/1"), "of another machine");
  EXPECT_EQ(disk.get("ac/1"), "of another machine");
  EXPECT_EQ(store.get("ac/2"), "of this one");
  EXPECT_EQ(store.get("ac/3"), std::nullopt);
}

TEST(SharedStore, PutsIntoBoth) {
  MemoryStore disk, remote;
  {
    SharedStore store(disk, remote, SharedStore::Sends::puts);
    EXPECT_TRUE(store.put("ac/1", "result"));
    EXPECT_TRUE(store.put("cas/1", "picture"));
    EXPECT_TRUE(store.put("list/1", "short"));
    EXPECT_TRUE(store.put("list/1", "longer"));
    EXPECT_EQ(disk.get("list/1"), "longer");
  }
  EXPECT_EQ(remote.get("ac/1"), "result");
  EXPECT_EQ(remote.get("cas/1"), "picture");
  EXPECT_EQ(remote.get("list/1"), "longer");
}

TEST(SharedStore, TellsNobodyWhatConcernsThisMachineAlone) {
  MemoryStore disk, remote;
  remote.put("here/2", "of another machine");
  {
    SharedStore store(disk, remote, SharedStore::Sends::puts);
    store.put("here/1", "files");
    EXPECT_EQ(store.get("here/1"), "files");
    EXPECT_EQ(store.get("here/2"), std::nullopt);
  }
  EXPECT_EQ(remote.get("here/1"), std::nullopt);
}

TEST(SharedStore, OnlyReadsWhereItIsNotToBeWritten) {
  MemoryStore disk, remote;
  remote.put("ac/1", "of another machine");
  {
    SharedStore store(disk, remote, SharedStore::Sends::nothing);
    store.put("ac/2", "result");
    EXPECT_EQ(store.get("ac/1"), "of another machine");
  }
  EXPECT_EQ(remote.get("ac/2"), std::nullopt);
}

TEST(SharedStore, SaysThatAFullDiskHasNothing) {
  Full disk;
  MemoryStore remote;
  {
    SharedStore store(disk, remote, SharedStore::Sends::puts);
    EXPECT_FALSE(store.put("ac/1", "result"));
  }
  EXPECT_EQ(remote.get("ac/1"), "result");
}

TEST(SharedStore, HasTheListsOfOthersApart) {
  MemoryStore disk, remote;
  disk.put("list/1", "own");
  remote.put("list/1", "theirs");
  SharedStore store(disk, remote, SharedStore::Sends::puts);
  EXPECT_EQ(store.get("list/1"), "own");
  EXPECT_EQ(store.get_of_others("list/1"), "theirs");
}

TEST(SharedStore, SendsWhatTheDiskHadBeforeWhereThatIsWanted) {
  MemoryStore disk, remote;
  disk.put("ac/1", "result");
  disk.put("list/1", "of one");
  SharedStore store(disk, remote, SharedStore::Sends::all);
  EXPECT_EQ(store.get("ac/1"), "result");
  EXPECT_EQ(store.get("list/1"), "of one");
  store.wait();
  EXPECT_EQ(remote.get("ac/1"), "result");
  EXPECT_EQ(remote.get("list/1"), std::nullopt) << "it would take another's place";
  EXPECT_FALSE(store.came_from_there("ac/1"));
}

TEST(SharedStore, KnowsWhatItGotFromThere) {
  MemoryStore disk, remote;
  remote.put("ac/1", "of another machine");
  SharedStore store(disk, remote, SharedStore::Sends::nothing);
  EXPECT_FALSE(store.came_from_there("ac/1"));
  store.get("ac/1");
  EXPECT_TRUE(store.came_from_there("ac/1"));
}

}  // namespace
}  // namespace mjcourse
