#include "remote/shared_store.h"

#include <gtest/gtest.h>

#include "memory_store.h"

namespace mjcourse {
namespace {

class Full : public MemoryStore {
 public:
  bool keep(const std::string&, std::string_view, const Origin&) override { return false; }
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
  EXPECT_EQ(store.find_of_others("list/1")->bytes, "theirs");
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

// What came from elsewhere is nothing to be sent on, nor is what was made of it.
TEST(SharedStore, SendsNothingThatWasNotMadeHere) {
  const Origin theirs = Origin::unsigned_one(),
               signed_one = Origin::signed_by(std::string(64, 'a'));
  MemoryStore disk, remote;
  disk.keep("ac/1", "result", theirs);
  disk.keep("ac/2", "result", signed_one);
  disk.put("ac/3", "result");
  SharedStore store(disk, remote, SharedStore::Sends::all);
  for (const char* name : {"ac/1", "ac/2", "ac/3"}) EXPECT_EQ(store.get(name), "result");
  store.wait();
  EXPECT_EQ(remote.get("ac/1"), std::nullopt);
  EXPECT_EQ(remote.get("ac/2"), std::nullopt);
  EXPECT_EQ(remote.get("ac/3"), "result");
}

TEST(SharedStore, KeepsWhereAllIsFrom) {
  const Origin theirs = Origin::unsigned_one();
  MemoryStore disk, remote;
  remote.keep("ac/1", "of another machine", theirs);
  SharedStore store(disk, remote, SharedStore::Sends::puts);
  EXPECT_EQ(store.find("ac/1")->origin, theirs);
  EXPECT_EQ(disk.find("ac/1")->origin, theirs);
  store.keep("ac/2", "made of it", theirs);
  EXPECT_EQ(disk.find("ac/2")->origin, theirs);
  store.put("ac/3", "made here");
  EXPECT_EQ(disk.find("ac/3")->origin, Origin());
  store.wait();
  EXPECT_EQ(remote.find("ac/2")->origin, theirs);
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
