// The whole of evaluating: what is kept is what was worked out, and threads change nothing.
#include "evaluate/evaluate.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "base/sha256.h"
#include "evaluate/codec/result_codec.h"
#include "evaluate/evaluation_of.h"
#include "memory_store.h"

namespace mjcourse {
namespace {

using namespace std::chrono_literals;

// A block of every kind that can be kept.
const std::map<std::string, std::string> kFiles{{"examples/say.cpp", R"(#include <cstdio>
#include <cstdlib>
int main() {
  std::FILE* records = std::fopen(std::getenv("MJCOURSE_RECORDS"), "w");
  std::fputs("{\"result\": \"x\", \"value\": 0.1}\n", records);
  std::fputs("{\"table\": \"t\", \"value\": [[\"time\", [0, 1]], [\"y\", [0.1, 0.2]]]}\n", records);
  std::fclose(records);
  std::puts("said");
}
)"}};
const std::string kBody =
    R"($x$ and $$y$$ of [the ball](model:ball), `{ball} model.nq`, `{say} x :.3f`

```cpp file=examples/say.cpp
```

```text
said
```

```cpp snippet model=ball
std::printf("%d\n", model->nq);
```

```text
8
```

```xml model=ball
<actuator><motor name="motor" joint="slide"/></actuator>
```

```xml mjcf
<mujoco/>
```

```lab simlab
{"title": "L", "height": 20, "model": "ball", "alt": "A ball.",
 "readouts": [{"label": "z", "expr": "data.qpos[2]"}],
 "controls": [{"type": "slider", "label": "push", "bind": "data.ctrl[0]", "min": 0, "max": 1}]}
```

```figure
{"model": "ball", "alt": "A ball.", "size": [100, 50]}
```

```plot
{"data": {"name": "say/t"}, "alt": "Two points.", "caption": "P", "mark": "line",
 "encoding": {"x": {"field": "time", "type": "quantitative"},
              "y": {"field": "y", "type": "quantitative"}}}
```
)";

std::size_t reused(const Evaluation& evaluation) {
  return static_cast<std::size_t>(std::count_if(evaluation.times.begin(), evaluation.times.end(),
                                                [](const TaskTime& time) { return time.reused; }));
}

// All that was found, to the bit, but for what was measured.
std::string all_of(const Evaluation& evaluation, Store& store) {
  const ResultCodec codec(store, "/nowhere");
  Finding finding;
  finding.results = evaluation.lessons.at(0).of_block;
  for (auto& [block, result] : finding.results) {
    if (auto* example = std::get_if<ExampleResult>(&result)) example->run_seconds = 0;
  }
  std::string all = codec.encode(finding, 0).value();
  for (const ModelPage& page : evaluation.models) {
    Finding model;
    model.model_page = page;
    all += codec.encode(model, 0).value();
  }
  return sha256(all);
}

TEST(Evaluation, HasTheResultsOfEachPageWhereverItLies) {
  Course course;
  course.add({});
  course.add({});
  course.glossary.emplace();
  Evaluation evaluation;
  evaluation.lessons.resize(2);
  const std::vector<Lesson> elsewhere = std::move(course.lessons);
  EXPECT_EQ(&evaluation.results_of(elsewhere[0]), &evaluation.lessons[0]);
  EXPECT_EQ(&evaluation.results_of(elsewhere[1]), &evaluation.lessons[1]);
  EXPECT_EQ(&evaluation.results_of(course.glossary->page), &evaluation.glossary);
}

TEST(Evaluate, GivesWhatIsKeptAsItWasFound) {
  MemoryStore store, scratch;
  const EvaluationOf alone(kBody, kFiles);
  ASSERT_EQ(alone.mistakes(), "");
  std::this_thread::sleep_for(50ms);
  EvaluationOf first(kBody, kFiles, &store);
  EXPECT_EQ(reused(first.evaluation()), 0);
  first.again();  // the course lay there before the work began
  first.again();
  const std::size_t tasks = first.evaluation().times.size();
  EXPECT_EQ(tasks, 11);
  EXPECT_EQ(reused(first.evaluation()), tasks);
  const std::string plainly = all_of(alone.evaluation(), scratch);  // whose pictures are here
  EXPECT_EQ(all_of(first.evaluation(), scratch), plainly);
  EXPECT_EQ(first.claims().size(), alone.claims().size());
  for (std::size_t i = 0; i < alone.claims().size(); ++i) {
    EXPECT_EQ(first.claims()[i].key, alone.claims()[i].key) << alone.claims()[i].what;
  }
}

TEST(Evaluate, KeepsNothingThatWasSaidSomethingOf) {
  MemoryStore store;
  EvaluationOf wrong("`{ball} model.nqq` and $\\alhpa$\n", {}, &store);
  const std::string mistakes = wrong.mistakes();
  EXPECT_NE(mistakes, "");
  std::this_thread::sleep_for(50ms);
  wrong.again();
  EXPECT_EQ(wrong.mistakes(), mistakes);
  EXPECT_EQ(reused(wrong.evaluation()), 0);
}

}  // namespace
}  // namespace mjcourse
