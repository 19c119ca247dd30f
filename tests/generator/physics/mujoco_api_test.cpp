#include "physics/mujoco_api.h"

#include <gtest/gtest.h>

#include <regex>

namespace mjcourse {
namespace {

using Kind = ApiName::Kind;

std::string text_of(const std::string& header) {
  return DiskFiles(mujoco_headers_folder()).read("mujoco/" + header).value();
}

const MujocoApi& installed() {
  static const MujocoApi api = read_mujoco_api(DiskFiles(mujoco_headers_folder())).value();
  return api;
}

const ApiName& named(const std::string& name) {
  const auto found = installed().find(name);
  if (found == installed().end()) throw std::runtime_error("there is no " + name);
  return found->second;
}

// What a plain search finds in a header, by its first group.
std::vector<std::string> searched(const std::string& header, const std::string& pattern) {
  const std::string text = text_of(header);
  const std::regex regex(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    found.push_back((*it)[1]);
  }
  return found;
}

TEST(MujocoApi, HasEveryFunctionOfTheHeader) {
  const auto functions = searched("mujoco.h", R"(\nMJAPI (?!extern)[^(;]*?\b(mj\w+)\()");
  EXPECT_GT(functions.size(), 250U);
  for (const std::string& name : functions) {
    ASSERT_TRUE(installed().contains(name)) << name;
    EXPECT_EQ(named(name).kind, Kind::function) << name;
    EXPECT_NE(named(name).comment, "") << name;
    EXPECT_NE(named(name).section, "") << name;
    EXPECT_TRUE(named(name).declaration.ends_with(");")) << named(name).declaration;
  }
  std::size_t found = 0;
  for (const auto& [name, entry] : installed()) found += entry.kind == Kind::function ? 1 : 0;
  EXPECT_EQ(found, functions.size());
}

TEST(MujocoApi, HasEveryStructureEnumerationAndConstant) {
  for (const char* header : {"mjmodel.h", "mjdata.h", "mjvisualize.h", "mjrender.h", "mjui.h"}) {
    for (const std::string& name :
         searched(header, R"(\n(?:typedef )?(?:struct|enum) (mj\w+)_ \{)")) {
      ASSERT_TRUE(installed().contains(name)) << name;
      EXPECT_EQ(named(name).header, header);
      EXPECT_TRUE(named(name).declaration.find('}') != std::string::npos) << name;
    }
    for (const std::string& name : searched(header, R"(\n  (mj[A-Z0-9]+_\w+) *[,=/\n])")) {
      ASSERT_TRUE(installed().contains(name)) << name;
      EXPECT_EQ(named(name).kind, Kind::constant) << name;
    }
  }
}

TEST(MujocoApi, QuotesTheHeader) {
  EXPECT_EQ(named("mj_step").declaration, "void mj_step(const mjModel* m, mjData* d);");
  EXPECT_EQ(named("mj_step").comment,
            "Advance simulation, use control callback to obtain external force and control.");
  EXPECT_EQ(named("mj_step").header + ", " + named("mj_step").section, "mujoco.h, Main simulation");
  EXPECT_EQ(named("mj_loadXML").declaration,
            "mjModel* mj_loadXML(const char* filename, const mjVFS* vfs,\n"
            "                          char* error, int error_sz);");
  EXPECT_EQ(named("mj_loadXML").comment,
            "Parse XML file in MJCF or URDF format, compile it, return low-level model. "
            "If vfs is not NULL, look up files in vfs before reading from disk. "
            "If error is not NULL, it must have size error_sz.");
}

TEST(MujocoApi, HasFieldsUnderTheirStructures) {
  EXPECT_EQ(named("mjModel.nq").declaration, "int nq;");
  EXPECT_EQ(named("mjModel.nq").comment, "number of generalized coordinates = dim(qpos)");
  EXPECT_EQ(named("mjModel.nq").owner, "mjModel");
  EXPECT_EQ(named("mjData.qpos").comment, "position (nq x 1)");
  EXPECT_EQ(named("mjOption.gravity").declaration, "mjtNum gravity[3];");
  EXPECT_EQ(named("mjVisual.global.fovy").declaration, "float fovy;");
  EXPECT_FALSE(installed().contains("mjVisual.fovy"));
  EXPECT_FALSE(installed().contains("mjVisual.global"));
}

TEST(MujocoApi, HasTheRestOfIt) {
  EXPECT_EQ(named("mjJNT_HINGE").comment, "rotation angle (rad) around body-fixed axis (1)");
  EXPECT_EQ(named("mjJNT_FREE").declaration + " " + named("mjJNT_FREE").owner,
            "mjJNT_FREE = 0 mjtJoint");
  EXPECT_EQ(named("mjtJoint").comment, "type of degree of freedom");
  EXPECT_EQ(named("mjMAXVAL").declaration, "#define mjMAXVAL 1E+10");
  EXPECT_EQ(named("mjtNum").declaration, "typedef double mjtNum;");
  EXPECT_EQ(named("mjtByte").comment, "used for true/false");
  EXPECT_EQ(named("mjcb_control").kind, Kind::variable);
  EXPECT_EQ(named("mju_user_error").kind, Kind::variable);
  EXPECT_EQ(named("mjfGeneric").kind, Kind::type);
  EXPECT_EQ(named("mju_sqrt").declaration, "#define mju_sqrt sqrt");
  EXPECT_EQ(named("mjDISABLESTRING").kind, Kind::variable);
}

TEST(MujocoApi, TakesWhatIsNoHeaderForNothing) {
  MujocoApi api;
  read_api_header("x.h", "MJAPI void mj_a(\nstruct mjB_ {\n int x\n} } ;\n\"typedef\" ((((", api);
  read_api_header("y.h", std::string("\0", 1) + "\xff\n}\n};\nMJAPI ;\ntypedef ;\n", api);
  EXPECT_LE(api.size(), 2U);
  EXPECT_EQ(read_mujoco_api(MemoryFiles({})).error(), "mujoco/mujoco.h: No such file or directory");
}

}  // namespace
}  // namespace mjcourse
