#include "script/engine.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace mjcourse {

// A bundle of ours for tests.
constexpr const char* functions = R"js(
  globalThis.join = (a, b) => a + "|" + b;
  globalThis.fail = (what) => { throw new TypeError(what); };
  globalThis.hang = () => { try { while (true); } catch { return "caught"; } };
  globalThis.when = () => JSON.stringify([new Date().getTime(), Date.now(), Date(),
                                          new Date(5).getTime(), new Date() instanceof Date]);
  globalThis.chance = () => String(Math.random());
  globalThis.twice = (x) => x + x;
)js";

class EngineTest : public testing::Test {
 protected:
  EngineTest() { engine_.load(functions, "functions.js"); }

  Engine engine_{0.2};
};

TEST_F(EngineTest, TextsGoInAndComeBack) {
  EXPECT_EQ(engine_.call("join", {"é𝄞\"\n", ""}).value(), "é𝄞\"\n|");
}

TEST_F(EngineTest, AnExceptionIsAnError) {
  const auto result = engine_.call("fail", {"no luck"});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().id, "E-script-throw");
  EXPECT_EQ(result.error().message, "TypeError: no luck");
}

TEST_F(EngineTest, AnEndlessLoopEndsAndTheEngineGoesOn) {
  for (int i = 0; i < 3; ++i) {
    const auto result = engine_.call("hang", {});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().id, "E-script-time");
    EXPECT_EQ(result.error().message, "ran for more than 0.2 s");
    EXPECT_EQ(engine_.call("twice", {"ab"}).value(), "abab");
  }
}

TEST_F(EngineTest, ManyShortCallsAreNoLongOne) {
  // longer than the limit all together
  for (int i = 0; i < 200000; ++i) ASSERT_TRUE(engine_.call("twice", {"ab"}));
}

TEST_F(EngineTest, EnginesRunSideBySide) {
  std::vector<std::thread> threads;
  std::atomic<int> right = 0;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&right] {
      Engine engine(0.1);
      engine.load(functions, "functions.js");
      const bool stopped = !engine.call("hang", {});
      if (stopped && engine.call("twice", {"ab"}).value_or("") == "abab") ++right;
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, 4);
}

TEST_F(EngineTest, TheClockStandsStill) {
  EXPECT_EQ(engine_.call("when", {}).value(),
            R"([946684800000,946684800000,"2000-01-01T00:00:00.000Z",5,true])");
}

TEST_F(EngineTest, ChanceRepeatsInEveryEngine) {
  Engine other;
  other.load(functions, "functions.js");
  const auto first = engine_.call("chance", {});
  EXPECT_EQ(first.value(), other.call("chance", {}).value());
  EXPECT_NE(first.value(), engine_.call("chance", {}).value());
}

TEST_F(EngineTest, ABrokenBundleIsOurMistake) {
  EXPECT_THROW(engine_.load("let 1", "broken.js"), std::runtime_error);
  EXPECT_THROW(engine_.call("absent", {}).value(), std::logic_error);
}

}  // namespace mjcourse
