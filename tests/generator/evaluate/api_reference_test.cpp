#include "evaluate/api_reference.h"

#include <gtest/gtest.h>

#include "course/course_of.h"
#include "physics/mujoco_api.h"

namespace mjcourse {
namespace {

struct ApiOf {
  explicit ApiOf(const std::string& x, const std::string& front = "",
                 const Files& headers = DiskFiles(mujoco_headers_folder()))
      : read(course_of(x, "", front)),
        api(read_mujoco_api(headers)),
        entries(evaluate_api(
            *read.course,
            [this](const Lesson& page) -> const auto& {
              return &page == &read.course->lessons[0] ? results : none;
            },
            [this]() -> const auto& { return api; }, 2, read.diagnostics)) {}

  // Each block of the first lesson is found to be as it is written.
  static LessonResults found(const Course& course) {
    LessonResults results;
    const std::vector<Block>& blocks = course.lessons[0].blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (const auto* example = std::get_if<Example>(&blocks[i])) {
        results.of_block[i] = ExampleResult{example->code.text, ""};
      } else if (std::holds_alternative<Snippet>(blocks[i])) {
        results.of_block[i] = ExampleResult{};
      } else if (std::holds_alternative<InlineValue>(blocks[i])) {
        results.of_block[i] = ValueResult{};
      }
    }
    return results;
  }

  // "mj_step: line 2 of block 1".
  std::string in_code() const {
    std::string text;
    for (const ApiEntry& entry : entries) {
      text += entry.name + ":";
      for (const CodeUse& use : entry.uses_in_code) {
        for (const int line : use.lines) text += " line " + std::to_string(line) + " of";
        text += " block " + std::to_string(use.block);
      }
      text += "\n";
    }
    return text;
  }

  CourseOf read;
  LessonResults results = found(*read.course), none;
  tl::expected<MujocoApi, std::string> api;
  std::vector<ApiEntry> entries;
};

TEST(ApiReference, TellsWhatTheHeaderTells) {
  const ApiOf api("[a](api:mj_step) [b](api:mjData.qpos) [c](api:mj_step) [d](api:mjMAXVAL)\n");
  EXPECT_EQ(api.read.mistakes(), "");
  std::string text;
  for (const ApiEntry& entry : api.entries) {
    text += entry.name + ": " + entry.kind + ", " + entry.header + ", " + entry.section + "; " +
            entry.declaration + " " + entry.url + "\n";
  }
  const std::string documentation = "https://mujoco.readthedocs.io/en/2.2.2/APIreference.html";
  EXPECT_EQ(text, "mjData.qpos: field of mjData, mjdata.h, mjData; mjtNum* qpos; " + documentation +
                      "#mjdata\n"
                      "mjMAXVAL: macro, mjmodel.h, ; #define mjMAXVAL 1E+10 \n"
                      "mj_step: function, mujoco.h, Main simulation; "
                      "void mj_step(const mjModel* m, mjData* d); " +
                      documentation + "#mj-step\n");
}

TEST(ApiReference, SuggestsTheNameThatWasMeant) {
  EXPECT_EQ(ApiOf("Call [it](api:mj_setp).\n").read.mistakes(),
            R"(content/1-a/1.1-x.md:4:15: error: MuJoCo has no `mj_setp` [E-api-unknown]
  4 | Call [it](api:mj_setp).
    |               ^~~~~~~
  cure: did you mean `mj_step`?
)");
  EXPECT_EQ(ApiOf("[a](api:model.nq)\n").read.diagnostics.at(0).cure, "did you mean `mjModel.nq`?");
}

TEST(ApiReference, OfDraftsIsCheckedAndLeftOut) {
  EXPECT_TRUE(ApiOf("[a](api:mj_step)\n", "draft: true\n").entries.empty());
  EXPECT_EQ(ApiOf("[a](api:mj_setp)\n", "draft: true\n").read.diagnostics.size(), 1U);
}

TEST(ApiReference, NeedsTheHeadersOnlyForALink) {
  EXPECT_EQ(ApiOf("None.\n", "", MemoryFiles({})).read.mistakes(), "");
  EXPECT_EQ(
      ApiOf("[a](api:mj_step)\n", "", MemoryFiles({})).read.mistakes(),
      R"(content/1-a/1.1-x.md:4:9: error: MuJoCo's headers cannot be read: mujoco/mujoco.h: No such file or directory [E-api-headers]
  4 | [a](api:mj_step)
    |         ^~~~~~~
  cure: name their folder in the environment's MJCOURSE_HEADERS
)");
}

TEST(ApiReference, HasWhatIsUsedInCode) {
  const std::string text =
      "[a](api:mj_step), `{x} model.nq`\n\n```cpp file=examples/a.cpp\nint main() {\n"
      "  mj_step(m, d);\n  mj_step(m, d);\n}\n```\n\n```cpp snippet model=x\n"
      "mj_forward(model, data);\n//| mj_inverse(model, data);\n```\n\n"
      "```cpp unchecked\nmj_fwdVelocity(m, d);\n```\n\n"
      "```cpp file=examples/b.cpp expect=compile-error\nmj_stop(mj_id2name);\n```\n";
  EXPECT_EQ(ApiOf(text).in_code(),
            "mjModel.nq: block 0\n"
            "mj_forward: block 2\n"
            "mj_step: line 2 of line 3 of block 1\n");
  EXPECT_EQ(ApiOf(text, "draft: true\n").in_code(), "");
}

TEST(ApiReference, OfCodeIsLeftOutWithoutHeaders) {
  const ApiOf api("`{x} model.nq`\n", "", MemoryFiles({}));
  EXPECT_EQ(api.read.mistakes(), "");
  EXPECT_TRUE(api.entries.empty());
}

}  // namespace
}  // namespace mjcourse
