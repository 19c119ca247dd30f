#include "physics/model.h"

#include <gtest/gtest.h>

#include <thread>

#include "physics/model_folder.h"

namespace mjcourse {
namespace {

ModelError error_of(const tl::expected<Model, ModelError>& model) {
  EXPECT_FALSE(model.has_value()) << "the model loaded";
  return model ? ModelError{} : model.error();
}

const std::string kArm = R"(<mujoco>
  <worldbody>
    <body name="upper"><joint name="shoulder"/><geom size="0.1"/>
      <body pos="1 0 0"><joint/><geom size="0.1"/></body>
    </body>
  </worldbody>
</mujoco>)";

TEST(Model, LoadsTextAndFileAlike) {
  const ModelFolder folder;
  const auto text = load_model_text(kArm);
  const auto file = load_model_file(folder.write("arm.xml", kArm));
  ASSERT_TRUE(text.has_value()) << text.error().message;
  ASSERT_TRUE(file.has_value()) << file.error().message;
  EXPECT_EQ((*text)->nq, 2);
  EXPECT_EQ((*file)->nq, 2);
  EXPECT_TRUE(file->warnings().empty());
  EXPECT_NE(text->serial(), file->serial());
}

TEST(Model, KnowsItsObjectsByName) {
  const Model model = load_model_text(kArm).value();
  EXPECT_EQ(model.id(mjOBJ_JOINT, "shoulder"), 0);
  EXPECT_EQ(model.id(mjOBJ_JOINT, "elbow"), -1);
  EXPECT_EQ(model.name(mjOBJ_JOINT, 0), "shoulder");
  EXPECT_EQ(model.name(mjOBJ_JOINT, 1), "");
  EXPECT_EQ(model.name(mjOBJ_JOINT, 99), "");
  EXPECT_EQ(model.names(mjOBJ_BODY), (std::vector<std::string>{"world", "upper"}));
  EXPECT_TRUE(model.names(mjOBJ_KEY).empty());
}

TEST(Model, SaysWhereTextIsWrong) {
  const ModelError schema =
      error_of(load_model_text("<mujoco>\n<worldbody>\n<geom sizee='1'/>\n"
                               "</worldbody>\n</mujoco>"));
  EXPECT_EQ(schema.file, "");
  EXPECT_EQ(schema.line, 3);
  EXPECT_EQ(schema.message, "element 'geom': unrecognized attribute: 'sizee'");
  EXPECT_EQ(schema.cure, "did you mean `size`?");

  const ModelError compiler = error_of(load_model_text(
      "<mujoco>\n<worldbody>\n\n<geom name='ball' size='-1'/>\n</worldbody>\n</mujoco>"));
  EXPECT_EQ(compiler.line, 4);
  EXPECT_NE(compiler.message.find("sizes must be positive"), std::string::npos) << compiler.message;

  const ModelError parser = error_of(load_model_text("<mujoco>\n<worldbody>\n</mujoco>"));
  EXPECT_EQ(parser.line, 2);
  EXPECT_EQ(parser.message, "not well-formed XML: mismatched element 'worldbody'");
}

TEST(Model, SaysWhatIsMissing) {
  const ModelFolder folder;
  const ModelError file = error_of(load_model_file(folder.path("gone.xml")));
  EXPECT_EQ(file.file, folder.path("gone.xml"));
  EXPECT_EQ(file.line, 0);
  EXPECT_EQ(file.message, "file not found");

  const ModelError mesh = error_of(load_model_file(
      folder.write("mesh.xml",
                   "<mujoco>\n<asset>\n<mesh name='part' file='gone.stl'/>\n</asset>\n"
                   "</mujoco>")));
  EXPECT_EQ(mesh.line, 3);
  EXPECT_NE(mesh.message.find("object 'part': could not open STL file"), std::string::npos)
      << mesh.message;

  EXPECT_EQ(error_of(load_model_file(folder.write("empty.xml", ""))).message, "the file is empty");
  EXPECT_EQ(error_of(load_model_text("")).message, "the model is empty");
  EXPECT_EQ(error_of(load_model_text("no XML at all")).message,
            "not well-formed XML: parsing text");
  EXPECT_EQ(error_of(load_model_text("<html/>")).message, "Unrecognized XML model type: 'html'");
}

TEST(Model, LoadsFilesFromMemory) {
  const ModelFiles files{{"Arm.xml", "<mujoco><include file='parts/hand.xml'/></mujoco>"},
                         {"hand.xml", kArm}};
  const auto model = load_model_files("Arm.xml", files);
  ASSERT_TRUE(model.has_value()) << model.error().message;
  EXPECT_EQ((*model)->nq, 2);
}

TEST(Model, SaysWhichOfTheFilesIsWrong) {
  const auto told = [](const ModelFiles& files) {
    const ModelError error = error_of(load_model_files("arm.xml", files));
    return error.file + ": " + error.message;
  };
  EXPECT_EQ(told({}), "arm.xml: file not found");
  EXPECT_EQ(told({{"arm.xml", kArm}, {"arm.png", ""}}), "arm.png: the file is empty");
  EXPECT_EQ(told({{"a/arm.xml", kArm}, {"arm.xml", kArm}}),
            "arm.xml: another file has the same name");
}

TEST(Model, KeepsTheCompilersWarnings) {
  const auto model = load_model_text(R"(<mujoco><size njmax="2" nconmax="1"/><worldbody>
    <geom type="plane" size="1 1 1"/>
    <body pos="0 0 0.09"><freejoint/><geom type="box" size=".1 .1 .1"/></body>
  </worldbody></mujoco>)");
  ASSERT_TRUE(model.has_value()) << model.error().message;
  ASSERT_EQ(model->warnings().size(), 1u);
  EXPECT_NE(model->warnings()[0].find("Increase njmax above 2"), std::string::npos)
      << model->warnings()[0];
}

TEST(Model, LoadsOnManyThreadsAtOnce) {
  const auto load_often = [](int* right) {
    for (int i = 0; i < 20; ++i) {
      const auto good = load_model_text(kArm);
      const auto bad =
          load_model_text("<mujoco>\n<worldbody>\n<geom size='-1'/></worldbody></mujoco>");
      if (good && !bad && bad.error().line == 3) ++*right;
    }
  };
  int first = 0, second = 0, third = 0;
  std::thread a(load_often, &first), b(load_often, &second), c(load_often, &third);
  a.join();
  b.join();
  c.join();
  EXPECT_EQ(first + second + third, 60);
}

}  // namespace
}  // namespace mjcourse
