#include "physics/model_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "physics/model.h"
#include "physics/model_folder.h"

namespace mjcourse {
namespace {

constexpr const char* kWedge =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string shown(const std::map<std::string, std::string>& files, const ModelFolder& folder) {
  std::string text;
  for (const auto& [name, path] : files) {
    text += name + "=" + std::filesystem::relative(path, folder.path("")).string() + " ";
  }
  return text;
}

class ModelSourcesTest : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& content) {
    const std::filesystem::path path(folder_.path(name));
    std::filesystem::create_directories(path.parent_path());
    return folder_.write(name, content);
  }
  // Of models/main.xml, which is `mjcf` inside <mujoco> and must compile.
  std::string found(const std::string& mjcf) {
    const std::string main = write("models/main.xml", "<mujoco>" + mjcf + "</mujoco>");
    const auto model = load_model_file(main);
    EXPECT_TRUE(model) << model.error().message;
    const auto sources = find_model_sources(folder_.path(""), "models/main.xml");
    if (!sources) return sources.error();
    EXPECT_EQ(sources->main, "main.xml");
    return shown(sources->texts, folder_) + "| " + shown(sources->assets, folder_);
  }

  ModelFolder folder_;
};

TEST_F(ModelSourcesTest, AreTheModelAloneWhereItNamesNothing) {
  EXPECT_EQ(found("<worldbody/>"), "main.xml=models/main.xml | ");
}

// Includes of includes are searched from the main file's folder, as MuJoCo does.
TEST_F(ModelSourcesTest, AreWhatItIncludes) {
  write("models/parts/arm.xml", "<mujoco><include file='parts/hand.xml'/><option/></mujoco>");
  write("models/parts/hand.xml", "<mujoco><worldbody/></mujoco>");
  EXPECT_EQ(found("<Include file='parts/arm.xml'/>"),
            "arm.xml=models/parts/arm.xml hand.xml=models/parts/hand.xml "
            "main.xml=models/main.xml | ");
}

TEST_F(ModelSourcesTest, AreFoundInTheFoldersOfTheCompiler) {
  write("models/m/wedge.obj", kWedge);
  write("models/set.xml", "<mujoco><compiler meshdir='m'/></mujoco>");
  const std::string mesh =
      "<asset><mesh name='a' file='wedge.obj'/><mesh name='b' file='wedge.obj' scale='2 2 2'/>"
      "</asset>";
  EXPECT_EQ(found(mesh + "<include file='set.xml'/>"),
            "main.xml=models/main.xml set.xml=models/set.xml | wedge.obj=models/m/wedge.obj ");
  EXPECT_EQ(found("<compiler meshdir='m/' strippath='true'/><asset><mesh file='x/y/wedge.obj'/>"
                  "</asset>"),
            "main.xml=models/main.xml | wedge.obj=models/m/wedge.obj ");
  EXPECT_EQ(found("<compiler meshdir='" + folder_.path("models/m") +
                  "'/><asset><mesh file='wedge.obj'/></asset>"),
            "main.xml=models/main.xml | wedge.obj=models/m/wedge.obj ");
  EXPECT_EQ(found("<asset><mesh file='../models/m/wedge.obj'/></asset>"),
            "main.xml=models/main.xml | wedge.obj=models/m/wedge.obj ");
}

TEST_F(ModelSourcesTest, AreMeshesTexturesHeightFieldsAndSkins) {
  const auto hfield = [](int rows, int columns) {
    std::string bytes(8, '\0');
    bytes[0] = static_cast<char>(rows);
    bytes[4] = static_cast<char>(columns);
    return bytes + std::string(static_cast<std::size_t>(4 * rows * columns), '\0');
  };
  write("models/m/hills.bin", hfield(2, 2));
  // width, height, then three bytes a pixel: MuJoCo's own format of a texture
  std::string texture(8, '\0');
  texture[0] = texture[4] = 1;
  texture += "abc";
  for (const char* name : {"front", "back", "left", "right", "up", "down", "plain"}) {
    write("models/t/" + std::string(name) + ".tex", texture);
  }
  EXPECT_EQ(found("<compiler meshdir='m' texturedir='t'/><asset>"
                  "<hfield name='h' file='hills.bin' size='1 1 1 1'/>"
                  "<texture name='p' type='2d' file='plain.tex'/>"
                  "<texture name='c' type='cube' filefront='front.tex' fileback='back.tex' "
                  "fileleft='left.tex' fileright='right.tex' fileup='up.tex' filedown='down.tex'/>"
                  "</asset>"),
            "main.xml=models/main.xml | back.tex=models/t/back.tex down.tex=models/t/down.tex "
            "front.tex=models/t/front.tex hills.bin=models/m/hills.bin left.tex=models/t/left.tex "
            "plain.tex=models/t/plain.tex right.tex=models/t/right.tex up.tex=models/t/up.tex ");
}

// A builtin texture has no need of its file.
TEST_F(ModelSourcesTest, AreNotWhatNobodyReads) {
  EXPECT_EQ(found("<asset><texture name='t' type='2d' builtin='flat' width='8' height='8' "
                  "file='none.png'/></asset>"),
            "main.xml=models/main.xml | ");
}

TEST_F(ModelSourcesTest, HaveNamesOfTheirOwn) {
  write("models/a/wedge.obj", kWedge);
  write("models/b/Wedge.obj", kWedge);
  EXPECT_EQ(found("<asset><mesh name='a' file='a/wedge.obj'/><mesh name='b' file='b/Wedge.obj'/>"
                  "</asset>"),
            "two files of the model are named Wedge.obj, and the page finds a file by its name "
            "alone");
}

TEST_F(ModelSourcesTest, AreNoMoreThanMuJoCoCanHold) {
  std::string assets;
  for (int i = 0; i < mjMAXVFS - 1; ++i) {
    const std::string name = "w" + std::to_string(i) + ".obj";
    write("models/" + name, kWedge);
    assets += "<mesh file='" + name + "'/>";
  }
  EXPECT_EQ(found("<asset>" + assets + "</asset>"),
            "the model has 2000 files; in the page MuJoCo has room for 1999");
}

TEST_F(ModelSourcesTest, AreNoChainWithoutEnd) {
  for (int i = 0; i < 3000; ++i) {
    write("models/p" + std::to_string(i) + ".xml",
          "<mujoco><include file='p" + std::to_string(i + 1) + ".xml'/></mujoco>");
  }
  write("models/main.xml", "<mujoco><include file='p0.xml'/></mujoco>");
  const NamedFiles named = look_at_model_files(folder_.path(""), "models/main.xml");
  ASSERT_TRUE(named.foreign);
  EXPECT_EQ(named.foreign->message, "the model includes more than 500 files");
  EXPECT_EQ(named.foreign->cure, "put parts of it into one");
}

TEST(FileNamedIn, IsTheFirst) {
  EXPECT_EQ(file_named_in("<mujoco><worldbody/></mujoco>"), "");
  EXPECT_EQ(file_named_in("<mujoco><asset><mesh file='a/b.obj'/><mesh file='c.obj'/></asset>"
                          "</mujoco>"),
            "a/b.obj");
  EXPECT_EQ(file_named_in("<mujoco><include file='part.xml'/></mujoco>"), "part.xml");
}

// What is wrong with models/main.xml, which is `mjcf`: "line message".
class BrowserTest : public ModelSourcesTest {
 protected:
  std::string wrong(const std::string& mjcf) {
    write("models/main.xml", mjcf);
    const NamedFiles named = look_at_model_files(folder_.path(""), "models/main.xml");
    if (!named.foreign) return "";
    return std::to_string(named.foreign->line) + " " + named.foreign->message + " | " +
           named.foreign->cure;
  }
};

// The site has the files under their own names, and a reader may open them there.
TEST_F(BrowserTest, GetsNoPageAndNoScriptByTheNameOfAnAsset) {
  const auto refused = [](const std::string& name) {
    return "2 the file '" + name +
           "' has an ending that no file of a model has | name it as what it is, such as x.png, "
           "x.stl, x.obj or x.bin";
  };
  for (const std::string name : {"x.html", "x.svg", "x.js", "x.mjs", "x.xhtml", "x.xml", "x.HTM"}) {
    write("models/" + name, "x");
    EXPECT_EQ(wrong("<mujoco><asset>\n<hfield name='a' file='" + name + "'/></asset></mujoco>"),
              refused(name));
  }
  write("models/x.bin", "x");
  EXPECT_EQ(wrong("<mujoco><asset>\n<hfield name='a' file='x.bin'/></asset></mujoco>"), "");
  write("models/x.html", "<mujoco><!--> <script>alert(1)</script> --></mujoco>");
  EXPECT_EQ(
      wrong("<mujoco>\n\n<include file='x.html'/></mujoco>"),
      "3 the file 'x.html' has an ending that no file of a model has | name it as what it is, "
      "such as x.xml");
}

TEST_F(BrowserTest, GetsNoInstructionsFromMjcf) {
  const std::string refused =
      "2 a model has no instructions for a browser | remove this line; the first may be `<?xml "
      "version=\"1.0\"?>`";
  EXPECT_EQ(
      wrong("<?xml version='1.0'?>\n<?xml-stylesheet href='x.xsl' type='text/xsl'?>\n<mujoco/>"),
      refused);
  EXPECT_EQ(wrong("<!-- a -->\n<!DOCTYPE mujoco [<!ENTITY a 'b'>]>\n<mujoco/>"), refused);
  EXPECT_EQ(wrong("<?xml version='1.0' encoding='utf-8'?>\n<!-- a -->\n<mujoco/>"), "");
  EXPECT_EQ(wrong("<?xml version='1.0' encoding='utf-7'?>\n<mujoco/>"),
            "1 a model's file is XML 1.0 in UTF-8, and says nothing else | save it in UTF-8; its "
            "first line may be `<?xml version=\"1.0\"?>`");
}

// Without a namespace a browser runs nothing, whatever the names.
TEST_F(BrowserTest, GetsNoNamespace) {
  const auto refused = [](int line, const std::string& name) {
    return std::to_string(line) + " a model has no namespaces, as by the attribute '" + name +
           "' | remove the attribute: MuJoCo does not look at it";
  };
  const auto colon = [](int line, const std::string& name) {
    return std::to_string(line) + " a model has no `:` in a name, as in '" + name +
           "' | write the name without it";
  };
  const std::string xhtml = "='http://www.w3.org/1999/xhtml'";
  // URDF may have any element, an include any attribute, and a file that is included any root.
  EXPECT_EQ(wrong("<robot name='r'>\n<link name='a'/>\n<script xmlns" + xhtml +
                  ">alert(1)</script></robot>"),
            refused(3, "xmlns"));
  write("models/inc.xml", "<mujocoinclude/>");
  EXPECT_EQ(wrong("<mujoco>\n<include file='inc.xml' autofocus='' onfocus='alert(1)' xmlns" +
                  xhtml + "/></mujoco>"),
            refused(2, "xmlns"));
  write("models/inc.xml", "<svg xmlns='http://www.w3.org/2000/svg' onload='alert(1)'/>");
  EXPECT_EQ(wrong("<mujoco><include file='inc.xml'/></mujoco>"), refused(1, "xmlns"));
  EXPECT_EQ(wrong("<robot name='r' xmlns:h" + xhtml + ">\n<h:script/></robot>"),
            refused(1, "xmlns:h"));
  EXPECT_EQ(wrong("<robot name='r' xmlns:xacro='http://ros.org/wiki/xacro'/>"),
            refused(1, "xmlns:xacro"));
  EXPECT_EQ(wrong("<robot name='r' xmlns=''/>"), refused(1, "xmlns"));
  EXPECT_EQ(wrong("<robot name='r'>\n<a xml:base='x'/></robot>"), colon(2, "xml:base"));
  EXPECT_EQ(wrong("<robot name='r'>\n\n<h:script/></robot>"),
            "3 a model has no `:` in a name | write the name without it");
  EXPECT_EQ(wrong("<robot name='r'>\n<link name='a'/>\n<script>alert(1)</script></robot>"), "");
}

// A browser runs what it has read before a mistake, and reads on elsewhere than MuJoCo.
TEST_F(BrowserTest, ReadsTheSameXmlAsMuJoCo) {
  EXPECT_EQ(wrong("<mujoco>\n<!-- a -- b --></mujoco>"),
            "2 this is no XML for a browser: a comment has `--` in it | write a single `-`");
  EXPECT_EQ(wrong("<mujoco/>\n<a xmlns='http://www.w3.org/1999/xhtml'/>"),
            "2 this is no XML for a browser: something follows its first element | put all of it "
            "into one element");
  EXPECT_EQ(wrong("<mujoco>\n<!ENTITY a 'b'></mujoco>"),
            "2 this is no XML for a browser: `E` cannot stand here | correct it, or remove it");
  EXPECT_EQ(wrong("<mujoco model='\xE9'/>"), "1 a model's file is in UTF-8 | save it in UTF-8");
}

// Some servers tell no type of an ending that they do not know, and browsers then guess it.
TEST_F(BrowserTest, TakesNoFileForAPage) {
  const auto asset = [&](const std::string& name, const std::string& bytes) {
    write("models/" + name, bytes);
    return wrong("<mujoco><asset>\n<hfield name='a' file='" + name + "'/></asset></mujoco>");
  };
  const auto refused = [](const std::string& name) {
    return "2 the file '" + name +
           "' begins as a page for a browser does | name a mesh, a texture or a height field";
  };
  EXPECT_EQ(asset("a", "<script>alert(1)</script>"), refused("a"));
  EXPECT_EQ(asset("b.bin", "\xEF\xBB\xBF \n<!-- --><script>alert(1)</script>"), refused("b.bin"));
  EXPECT_EQ(asset("c.dat", "<?xml version='1.0'?><html/>"), refused("c.dat"));
  EXPECT_EQ(asset("d.bin", std::string("<\0\0\0", 4)), "");
  const auto text = [&](const std::string& begin) {
    write("models/part.urdf", begin + "<mujocoinclude/>");
    return wrong("<mujoco><include file='part.urdf'/></mujoco>");
  };
  EXPECT_EQ(text("<!-- --> "),
            "1 a model's file that is not named .xml says first that it is XML | begin it with "
            "`<?xml version=\"1.0\"?>`, or name it .xml");
  EXPECT_EQ(text("<?xml version=\"1.0\"?>\n"), "");
}

}  // namespace
}  // namespace mjcourse
