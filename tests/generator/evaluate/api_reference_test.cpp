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
            *read.course, [this]() -> const auto& { return api; }, read.diagnostics)) {}

  CourseOf read;
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

}  // namespace
}  // namespace mjcourse
