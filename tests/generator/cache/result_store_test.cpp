#include "cache/result_store.h"

#include <gtest/gtest.h>

#include <thread>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "memory_store.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::system_clock;

// Of a machine that shares its results with others, and has lists of its own.
class OneOfMany : public MemoryStore {
 public:
  explicit OneOfMany(MemoryStore& shared) : shared_(shared) {}

  std::optional<Stored> find(const std::string& name) override {
    auto own = MemoryStore::find(name);
    return own ? own : shared_.find(name);
  }
  bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override {
    return shared_.keep(name, bytes, origin) && MemoryStore::keep(name, bytes, origin);
  }
  std::optional<Stored> find_of_others(const std::string& name) override {
    return shared_.find(name);
  }

 private:
  MemoryStore& shared_;
};

class ResultStoreTest : public testing::Test {
 protected:
  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }
  // The files were there before the work began.
  void keep(const Dependencies& recipe, const std::string& bytes) {
    std::this_thread::sleep_for(50ms);
    EXPECT_TRUE(results_.keep(recipe, trace_, Clock::now(), bytes));
  }
  std::string found(const Dependencies& recipe) {
    const auto found = results_.find(recipe);
    return found ? found->bytes : "nothing";
  }

  const Dependencies recipe_{{"text", "t"}, {"compiler", "clang 16"}, {"MuJoCo", "2.2.2"}};
  TemporaryFolder folder_;
  MemoryStore store_;
  Fingerprints prints_{folder_.path()};
  ResultStore results_{store_, prints_};
  Trace trace_{folder_.path()};
};

TEST_F(ResultStoreTest, FindsByTheRecipeAndWhatWasLookedAt) {
  write("models/a.xml", "one");
  trace_.file("models/a.xml");
  trace_.file(folder_.path() / "models" / "b.xml");
  EXPECT_EQ(found(recipe_), "nothing");
  keep(recipe_, "of one");
  EXPECT_EQ(found(recipe_), "of one");
  const Dependencies traced = results_.find(recipe_)->traced;
  ASSERT_EQ(traced.size(), 2);
  EXPECT_EQ(traced[0].name, "models/a.xml");
  EXPECT_EQ(traced[1], (Dependency{"models/b.xml", kAbsent}));

  write("models/a.xml", "two");
  EXPECT_EQ(found(recipe_), "nothing");
  keep(recipe_, "of two");
  EXPECT_EQ(found(recipe_), "of two");
  write("models/a.xml", "one");
  EXPECT_EQ(found(recipe_), "of one") << "both are kept";
  write("models/b.xml", "");
  EXPECT_EQ(found(recipe_), "nothing") << "a file that was looked for is there now";
}

TEST_F(ResultStoreTest, FindsWhatOthersLookedAt) {
  OneOfMany here(store_), there(store_);
  ResultStore ours(here, prints_), theirs(there, prints_);
  const auto keep_in = [&](ResultStore& results, const std::string& file) {
    write(file, "one");
    trace_.clear();
    trace_.file(file);
    std::this_thread::sleep_for(50ms);
    EXPECT_TRUE(results.keep(recipe_, trace_, Clock::now(), "of " + file));
  };
  keep_in(ours, "models/a.xml");
  keep_in(theirs, "models/b.xml");  // whose list has both
  write("models/a.xml", "two");
  EXPECT_EQ(ours.find(recipe_)->bytes, "of models/b.xml") << "which is not in our own list";
  keep_in(ours, "models/c.xml");
  write("models/c.xml", "two");
  EXPECT_EQ(ours.find(recipe_)->bytes, "of models/b.xml") << "which it has since";
  EXPECT_EQ(theirs.find(recipe_)->bytes, "of models/b.xml");
}

// Whatever a store gives, also under the right hash.
TEST_F(ResultStoreTest, TakesNoAnswerForThatOfAnotherQuestion) {
  write("models/a.xml", "one");
  trace_.file("models/a.xml");
  keep(recipe_, "mine");
  const Dependencies other{{"text", "u"}};
  keep(other, "another's");
  const std::string name = results_.find(recipe_)->name;
  const std::string own = store_.get(name).value();
  store_.put(name, store_.get(results_.find(other)->name).value());
  EXPECT_EQ(found(recipe_), "nothing");
  for (const std::string& odd : {std::string(), std::string("[]\n"), own.substr(0, 9)}) {
    store_.put(name, odd);
    EXPECT_EQ(found(recipe_), "nothing") << odd;
    EXPECT_TRUE(results_.dependencies_of(name).empty()) << odd;
  }
  store_.put(name, own);
  EXPECT_EQ(found(recipe_), "mine");
}

TEST_F(ResultStoreTest, TakesAnyOtherRecipeForAnother) {
  keep(recipe_, "kept");
  for (std::size_t i = 0; i < recipe_.size(); ++i) {
    Dependencies other = recipe_;
    other[i].value += "+";
    EXPECT_EQ(found(other), "nothing") << other[i].name;
  }
}

// What a program opens may depend on what another file says.
TEST_F(ResultStoreTest, RemembersSeveralWaysToLook) {
  write("which", "a");
  write("a", "1");
  write("b", "2");
  trace_.file("which");
  trace_.file("a");
  keep(recipe_, "by a");
  write("which", "b");
  trace_.clear();
  trace_.file("which");
  trace_.file("b");
  keep(recipe_, "by b");
  write("a", "changed");
  EXPECT_EQ(found(recipe_), "by b");
  write("which", "a");
  EXPECT_EQ(found(recipe_), "nothing");
}

// Of what was found, and of what is made of that.
TEST_F(ResultStoreTest, SaysWhereAResultIsFrom) {
  const Origin theirs = Origin::unsigned_one(), a = Origin::signed_by(std::string(64, 'a'));
  keep(recipe_, "made here");
  EXPECT_EQ(results_.find(recipe_)->origin, Origin());
  trace_.found({}, a);
  keep(recipe_, "made of what one has signed");
  EXPECT_EQ(results_.find(recipe_)->origin, a);
  Trace other(folder_.path());
  other.found({}, theirs);
  trace_.add(other);
  keep(recipe_, "and of what nobody has");
  EXPECT_EQ(results_.find(recipe_)->origin, theirs);
}

// A list is joined of those of several.
TEST_F(ResultStoreTest, SaysWhereAListIsFrom) {
  class Named : public MemoryStore {
   public:
    bool keep(const std::string& name, std::string_view bytes, const Origin& origin) override {
      if (name.starts_with("list/")) list = origin;
      return MemoryStore::keep(name, bytes, origin);
    }
    std::optional<Stored> find_of_others(const std::string&) override { return others; }
    std::optional<Stored> others;
    std::optional<Origin> list;
  };
  Named store;
  ResultStore results(store, prints_);
  std::this_thread::sleep_for(50ms);
  results.keep(recipe_, trace_, Clock::now(), "result");
  EXPECT_EQ(store.list, Origin());
  store.others = Stored{"[[\"course:other\"]]", Origin::unsigned_one()};
  results.keep(recipe_, trace_, Clock::now(), "result");
  EXPECT_EQ(store.list, Origin::unsigned_one());
}

// A store that others write into may say that there are a million.
TEST_F(ResultStoreTest, LooksInNoMoreWaysThanItRemembers) {
  class ListsAll : public OneOfMany {
   public:
    ListsAll(MemoryStore& shared, std::size_t ways) : OneOfMany(shared), ways_(ways) {}
    std::optional<Stored> find(const std::string& name) override {
      return name.starts_with("list/") ? Stored{lists()} : OneOfMany::find(name);
    }
    std::optional<Stored> find_of_others(const std::string&) override { return Stored{lists()}; }

   private:
    std::string lists() const {
      std::string all = "[";
      for (std::size_t i = 1; i < ways_; ++i) all += "[\"course:no" + std::to_string(i) + "\"], ";
      return all + "[]]";
    }
    std::size_t ways_;
  };
  keep(recipe_, "looked at nothing");
  ListsAll eight(store_, 8), nine(store_, 9);
  EXPECT_TRUE(ResultStore(eight, prints_).find(recipe_));
  EXPECT_FALSE(ResultStore(nine, prints_).find(recipe_));
}

TEST_F(ResultStoreTest, SeesWhichFileOfASetHasChanged) {
  const TemporaryFolder system;
  const std::string a = system.path() / "a.h", b = system.path() / "b.h";
  write_file(a, "one");
  write_file(b, "one");
  trace_.files({a, b, folder_.path() / "models/of_the_course.xml"});
  trace_.file("models/own.xml");
  keep(recipe_, "of one");
  const Dependencies before = ResultStore(store_, prints_).find(recipe_)->traced;
  ASSERT_EQ(before.size(), 3) << "two of the course, and the set";
  const Dependencies each = results_.one_by_one(before);
  ASSERT_EQ(each.size(), 4);
  EXPECT_EQ(each[2].name, a);
  EXPECT_EQ(each[3].name, b);

  write_file(b, "two");
  ResultStore later(store_, prints_);
  EXPECT_FALSE(later.find(recipe_));
  std::this_thread::sleep_for(50ms);
  const auto kept = later.keep(recipe_, trace_, Clock::now(), "of two");
  ASSERT_TRUE(kept);
  const Dependencies now = later.one_by_one(kept->traced);
  EXPECT_EQ(now[2], each[2]);
  EXPECT_EQ(now[3].name, b);
  EXPECT_NE(now[3].value, each[3].value);
  EXPECT_EQ(later.find(recipe_)->bytes, "of two");
  write_file(b, "one");
  EXPECT_EQ(ResultStore(store_, prints_).find(recipe_)->bytes, "of one") << "both are kept";
}

TEST_F(ResultStoreTest, SeesOnlyHeadersThatMayHideOneThatWasRead) {
  write("include/own/a.hpp", "one");
  trace_.headers_in("include", {folder_.path() / "include/own/a.hpp", "/usr/include/c.h"});
  keep(recipe_, "of one");
  const auto found_anew = [&] { return ResultStore(store_, prints_).find(recipe_).has_value(); };
  const Dependencies traced = results_.find(recipe_)->traced;
  ASSERT_EQ(traced.size(), 1);
  EXPECT_EQ(traced[0].value, "own/, own/a.hpp");
  write("include/own/b.hpp", "of another name");
  EXPECT_TRUE(found_anew());
  for (const char* hiding : {"include/a.hpp", "include/own/c.h", "include/more/b.hpp"}) {
    write(hiding, "one");
    EXPECT_FALSE(found_anew()) << hiding;
    std::filesystem::remove(folder_.path() / hiding);
    std::filesystem::remove(folder_.path() / "include/more");
    EXPECT_TRUE(found_anew()) << hiding;
  }
}

TEST_F(ResultStoreTest, KeepsNothingWhereAHeaderMayHaveComeMeanwhile) {
  write("include/own/a.hpp", "one");
  trace_.headers_in("include", {"a.hpp"});
  EXPECT_FALSE(results_.keep(recipe_, trace_, Clock::now() - 1h, "of one"));
}

TEST_F(ResultStoreTest, SaysWhatAResultDependsOn) {
  write("models/a.xml", "one");
  trace_.file("models/a.xml");
  keep(recipe_, "of one");
  const auto found = results_.find(recipe_);
  ASSERT_TRUE(found);
  Dependencies all = recipe_;
  all.insert(all.end(), found->traced.begin(), found->traced.end());
  EXPECT_EQ(results_.dependencies_of(found->name), all);
  EXPECT_EQ(results_.dependencies_of("ac/unknown"), Dependencies());
}

TEST_F(ResultStoreTest, KeepsNothingThatIsInDoubt) {
  write("a", "one");
  trace_.file("a");
  EXPECT_FALSE(results_.keep(recipe_, trace_, Clock::now() - 1h, "saved meanwhile"));
  EXPECT_EQ(found(recipe_), "nothing");
  std::this_thread::sleep_for(50ms);
  trace_.unknown();
  EXPECT_FALSE(results_.keep(recipe_, trace_, Clock::now(), "of who knows what"));
  EXPECT_EQ(found(recipe_), "nothing");
}

TEST(Trace, PutsOnlyFilesOfTheSystemIntoSets) {
  Trace trace("/home/a/course");
  trace.files({"/usr/include/b.h", "/home/a/course/examples/c.hpp", "/usr/include/d.h"});
  EXPECT_EQ(trace.names(), std::set<std::string>{"examples/c.hpp"});
  EXPECT_EQ(trace.sets(),
            (std::set<std::vector<std::string>>{{"/usr/include/b.h", "/usr/include/d.h"}}));
  trace.clear();
  EXPECT_TRUE(trace.sets().empty());
}

TEST(Trace, NamesTheCoursesFilesBelowIt) {
  Trace trace("/home/a/course");
  EXPECT_TRUE(trace.file("models/a.xml"));
  EXPECT_FALSE(trace.file("/home/a/course/models/../models/a.xml"));
  trace.file("/usr/include/b.h");
  trace.file("../c");
  trace.program("d");
  EXPECT_EQ(trace.names(),
            (std::set<std::string>{"/home/a/c", "/usr/include/b.h", "models/a.xml", "program d"}));
}

}  // namespace
}  // namespace mjcourse
