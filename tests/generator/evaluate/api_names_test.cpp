#include "evaluate/api_names.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(ApiNames, HaveKindDeclarationAndComment) {
  MujocoApi api;
  read_api_header("mujoco.h",
                  "// Advance simulation.\n"
                  "MJAPI void mj_step(const mjModel* m, mjData* d);\n",
                  api);
  read_api_header("mjmodel.h",
                  "struct mjModel_ {\n"
                  "  int nq;                 // number of generalized coordinates\n"
                  "};\n"
                  "typedef struct mjModel_ mjModel;\n",
                  api);
  EXPECT_EQ(api_names(api),
            R"j([["mjModel","type","",""],)j"
            R"j(["mjModel.nq","property","int nq","number of generalized coordinates"],)j"
            R"j(["mj_step","function","void mj_step(const mjModel* m, mjData* d)",)j"
            R"j("Advance simulation."]])j");
}

}  // namespace
}  // namespace mjcourse
