#include "physics/vetted_model.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <thread>

#include "physics/model_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class VettedModelTest : public testing::Test {
 protected:
  VettedModelTest() { fs::create_directory(folder_.path("models")); }

  std::string model(const std::string& mjcf) {
    return folder_.write("models/main.xml", "<mujoco>\n" + mjcf + "\n</mujoco>");
  }
  // The course is the folder, and `path` lies in it.
  tl::expected<Model, ModelError> load(const std::string& path) {
    return load_vetted_file(folder_.path(""), fs::path(path).lexically_relative(folder_.path("")));
  }
  // "models/main.xml:2: message", of a model that is not loaded.
  std::string refused(const std::string& path) {
    const auto loaded = load(path);
    if (loaded) return "nothing";
    return fs::path(loaded.error().file).lexically_relative(folder_.path("")).string() + ":" +
           std::to_string(loaded.error().line) + ": " + loaded.error().message;
  }

  ModelFolder folder_;
};

TEST_F(VettedModelTest, LoadsWhatDoesNoHarm) {
  folder_.write("models/part.xml",
                "<mujoco><worldbody><body><freejoint/><geom size='1'/></body>"
                "</worldbody></mujoco>");
  const auto loaded = load(model("<include file='part.xml'/>"));
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ((*loaded)->nq, 7);
  EXPECT_TRUE(load_vetted_text("<mujoco/>"));
}

TEST_F(VettedModelTest, SaysWhatMujocoSays) {
  EXPECT_EQ(refused(model("<worldbody><geom sizee='1'/></worldbody>")),
            "models/main.xml:2: element 'geom': unrecognized attribute: 'sizee'");
  EXPECT_EQ(refused(folder_.path("models/gone.xml")), "models/gone.xml:0: file not found");
}

TEST_F(VettedModelTest, SaysWhereInWhatItIncludes) {
  fs::create_directory(folder_.path("models/parts"));
  const std::string main = model("<include file='parts/hand.xml'/>");
  folder_.write("models/parts/hand.xml",
                "<mujoco>\n<worldbody/>\n<include file='parts/finger.xml'/></mujoco>");
  const auto finger = [&](const std::string& text) {
    folder_.write("models/parts/finger.xml", "<mujoco>\n" + text + "\n</mujoco>");
    return refused(main);
  };
  const std::string in_finger = "models/parts/finger.xml:";
  EXPECT_EQ(finger("<worldbody>\n<geom sizee='1'/></worldbody>"),
            in_finger + "3: element 'geom': unrecognized attribute: 'sizee'");
  EXPECT_EQ(
      finger("<worldbody>\n<body name='b'><freejoint/></body></worldbody>"),
      in_finger + "3: object 'b': mass and inertia of moving bodies must be larger than mjMINVAL");
  EXPECT_EQ(finger("<asset>\n\n<mesh name='m' file='gone.stl'/></asset>").substr(0, 39),
            in_finger + "4: object 'm': ");
  EXPECT_EQ(finger("<worldbody>\n\n</body>"),
            in_finger + "2: not well-formed XML: mismatched element 'worldbody'");
}

TEST_F(VettedModelTest, SaysWhereAnIncludeIsLookedFor) {
  fs::create_directory(folder_.path("models/parts"));
  const std::string main = model("<include file='parts/hand.xml'/>");
  EXPECT_EQ(refused(main),
            "models/main.xml:2: the file 'parts/hand.xml' is not there: it is looked for as "
            "models/parts/hand.xml");
  folder_.write("models/parts/hand.xml", "<mujoco>\n\n<include file='finger.xml'/></mujoco>");
  const std::string starts = "MuJoCo starts from the folder of the main file, models/main.xml";
  EXPECT_EQ(load(main).error().cure, starts);
  folder_.write("models/parts/finger.xml", "<mujoco><worldbody/></mujoco>");
  EXPECT_EQ(refused(main),
            "models/parts/hand.xml:3: the file 'finger.xml' is not there: it is looked for as "
            "models/finger.xml");
  EXPECT_EQ(load(main).error().cure, starts + ": write `parts/finger.xml`");
}

TEST_F(VettedModelTest, SaysWhichKeyframeIsOfAWrongSize) {
  folder_.write("models/keys.xml",
                "<mujoco><keyframe>\n<key/>\n<key name='low' qpos='1 2\n3'/></keyframe></mujoco>");
  const std::string main = model(
      "<worldbody><body><freejoint/><geom size='1'/></body></worldbody>\n"
      "<include file='keys.xml'/>");
  EXPECT_EQ(refused(main),
            "models/keys.xml:3: object 'low': key 1: invalid qpos size, expected length 7");
  EXPECT_EQ(load(main).error().cure, "write 7 numbers there, not 3");
}

TEST_F(VettedModelTest, SaysWhichSensorIsWrong) {
  folder_.write(
      "models/more.xml",
      "<mujoco><sensor>\n<framepos objtype='body' objname='b'/>\n"
      "<framepos objtype='body' objname='b' reftype='body' refname='c'/></sensor></mujoco>");
  const std::string main = model(
      "<worldbody><body name='b'/></worldbody><sensor><framequat objtype='body' objname='b'/>"
      "</sensor><include file='more.xml'/>");
  EXPECT_EQ(refused(main),
            "models/more.xml:3: unrecognized name of reference frame object in sensor '' (id = 2)");
  EXPECT_EQ(load(main).error().cure, "look at `refname`: nothing of its `reftype` has that name");
}

TEST_F(VettedModelTest, SaysWhereActuatorsAreInTheWrongOrder) {
  const std::string main = model(
      "<worldbody><body><joint name='j'/><geom size='1'/></body></worldbody>\n"
      "<actuator><intvelocity joint='j' actrange='0 1'/><motor joint='j'/></actuator>");
  EXPECT_EQ(refused(main),
            "models/main.xml:3: stateless actuators must come before stateful actuators");
  EXPECT_EQ(load(main).error().cure,
            "write those with an activation, as `<intvelocity>`, after all others");
}

TEST_F(VettedModelTest, SaysWhereTooSmallAStackIsAskedFor) {
  const std::string main = model(
      "<size nstack='50'/><worldbody><body><freejoint/><geom size='1'/>"
      "</body></worldbody>\n<size nstack='1'/>");
  EXPECT_EQ(refused(main), "models/main.xml:3: Stack overflow");
  EXPECT_EQ(load(main).error().cure,
            "nstack=\"1\" is too small for this model; without it, MuJoCo finds a size that does");
}

TEST_F(VettedModelTest, TakesNoWordOfAnAuthorsForWantOfMemory) {
  EXPECT_EQ(refused(model("<size memory='1M'/>")),
            "models/main.xml:2: element 'size': unrecognized attribute: 'memory'");
  EXPECT_EQ(refused(model("<worldbody><body name='allocated memory'><freejoint/></body>"
                          "</worldbody>")),
            "models/main.xml:2: object 'allocated memory': mass and inertia of moving bodies must "
            "be larger than mjMINVAL");
}

TEST_F(VettedModelTest, RefusesFilesOfOtherFolders) {
  folder_.write("outside.xml", "<mujoco/>");
  const std::string outside = "' lies outside of the folder of the model";
  for (const std::string& name : {std::string("../outside.xml"), std::string("/etc/passwd"),
                                  folder_.path("outside.xml"), std::string("../gone.xml")}) {
    EXPECT_EQ(refused(model("<include file='" + name + "'/>")),
              "models/main.xml:2: the file '" + name + outside);
  }
  EXPECT_EQ(refused(model("<asset>\n<mesh file='/etc/passwd'/></asset>")),
            "models/main.xml:3: the file '/etc/passwd" + outside);
  EXPECT_EQ(refused(model("<compiler texturedir='../..'/>\n<asset><texture type='2d' "
                          "file='x.png'/></asset>")),
            "models/main.xml:3: the file 'x.png" + outside);
}

TEST_F(VettedModelTest, RefusesLinksThatLeadThere) {
  folder_.write("outside.xml", "<mujoco/>");
  fs::create_symlink("../outside.xml", folder_.path("models/link.xml"));
  EXPECT_EQ(refused(model("<include file='link.xml'/>")),
            "models/main.xml:2: the file 'link.xml' lies outside of the folder of the model");
  EXPECT_EQ(refused(folder_.path("models/link.xml")),
            "models/link.xml:0: the model's file lies outside of the folder of the model");
}

// To read a pipe is to wait for its writer, and a device may have no end.
TEST_F(VettedModelTest, RefusesWhatIsNoFile) {
  ASSERT_EQ(mkfifo(folder_.path("models/pipe.xml").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(folder_.path("models/pipe.stl").c_str(), 0600), 0);
  EXPECT_EQ(refused(model("<include file='pipe.xml'/>")),
            "models/main.xml:2: the file 'pipe.xml' is neither a file nor a folder");
  EXPECT_EQ(refused(model("<asset><mesh file='pipe.stl'/></asset>")),
            "models/main.xml:2: the file 'pipe.stl' is neither a file nor a folder");
  EXPECT_EQ(refused(folder_.path("models/pipe.xml")),
            "models/pipe.xml:0: the model's file is neither a file nor a folder");
}

TEST_F(VettedModelTest, RefusesMjcfThatNobodyWrote) {
  folder_.write("models/large.xml", "");
  fs::resize_file(folder_.path("models/large.xml"), 1ull << 35);
  EXPECT_EQ(refused(model("<include file='large.xml'/>")),
            "models/main.xml:2: the file 'large.xml' is larger than 16 MiB");
}

TEST_F(VettedModelTest, RefusesACircle) {
  folder_.write("models/part.xml", "<mujoco>\n<include file='main.xml'/></mujoco>");
  EXPECT_EQ(refused(model("<include file='main.xml'/>")),
            "models/main.xml:2: the file 'main.xml' is included again");
  EXPECT_EQ(refused(model("<include file='part.xml'/>")),
            "models/part.xml:2: the file 'main.xml' is included again");
}

TEST_F(VettedModelTest, RefusesNumbersThatAreNone) {
  const auto body = [&](const std::string& attribute) {
    return refused(model("<worldbody>\n<body name='inf' " + attribute +
                         "><freejoint/><geom size='1'/></body></worldbody>"));
  };
  EXPECT_EQ(body("pos='0 nan 0'"), "models/main.xml:3: 'nan' is not a finite number");
  EXPECT_EQ(body("pos='0 0 -inf'"), "models/main.xml:3: '-inf' is not a finite number");
  EXPECT_EQ(body("pos='0 0 0'"), "nothing");
}

TEST_F(VettedModelTest, KnowsAFileThatChanged) {
  EXPECT_EQ(refused(model("<worldbody/>")), "nothing");
  EXPECT_EQ(refused(model("<worldbody><geom/></worldbody>")).substr(0, 18), "models/main.xml:2:");
}

TEST_F(VettedModelTest, RefusesATextThatNamesFiles) {
  const auto loaded = load_vetted_text("<mujoco>\n<include file='/etc/passwd'/></mujoco>");
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().line, 2);
  EXPECT_EQ(loaded.error().message,
            "a model inside a lesson cannot name files; this one names /etc/passwd");
}

TEST_F(VettedModelTest, RefusesASolverThatMayGoOnForEver) {
  EXPECT_EQ(refused(model("<option iterations='2000000000'/>")),
            "models/main.xml:0: the solver may take more than 100000 iterations");
}

// A model that is being loaded holds a lock of MuJoCo's, which a child must not inherit.
TEST_F(VettedModelTest, IsLoadedByManyAtOnce) {
  std::vector<int> loaded(4);
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < loaded.size(); ++t) {
      threads.emplace_back([&loaded, t] {
        for (int i = 0; i < 20; ++i) {
          const std::string name = std::to_string(t) + "_" + std::to_string(i);
          if (load_vetted_text("<mujoco model='" + name + "'/>")) ++loaded[t];
        }
      });
    }
  }
  EXPECT_EQ(loaded, (std::vector<int>{20, 20, 20, 20}));
}

}  // namespace
}  // namespace mjcourse
