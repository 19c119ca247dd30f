// A model's MJCF of any bytes: the files that it names, and what MuJoCo says of it.
//
// The input: MJCF, a line `=====`, MuJoCo's answer.
#include <algorithm>
#include <filesystem>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "fuzz.h"
#include "physics/mistakes/model_error.h"
#include "physics/model_files.h"
#include "require.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

// A course whose model is the input; beside it lies what it may name, and what it must not.
class CourseOfModel {
 public:
  CourseOfModel() {
    fs::create_directories(root() / "models/meshes");
    fs::create_directories(folder_.path() / "outside");
    write_file(root() / "models/part.xml", "<mujocoinclude><geom size='1'/></mujocoinclude>");
    write_file(root() / "models/meshes/a.stl", "solid");
    write_file(folder_.path() / "outside/secret.xml", "<mujoco/>");
    fs::create_symlink(folder_.path() / "outside", root() / "models/out");
    fs::create_symlink("part.xml", root() / "models/same.xml");
    // What would never end, were it read.
    fs::create_symlink("/dev/zero", root() / "models/endless.xml");
  }

  fs::path root() const { return folder_.path() / "course"; }

  void check(const std::string& mjcf) {
    write_file(root() / "models/m.xml", mjcf);
    const NamedFiles found = look_at_model_files(root(), "models/m.xml");
    for (const std::string& file : found.files) check_file(file);
    if (found.foreign) return;
    const auto sources = find_model_sources(root(), "models/m.xml");
    if (!sources) return;
    require(sources->texts.size() + sources->assets.size() <= found.files.size(),
            "no file but those that were looked at");
    for (const auto& [name, path] : sources->texts) check_file(path);
    for (const auto& [name, path] : sources->assets) check_file(path);
  }

 private:
  void check_file(const std::string& file) const {
    require(fs::canonical(file).string().starts_with(fs::canonical(root()).string() + "/"),
            "a file of the course: " + file);
  }

  TemporaryFolder folder_;
};

void check_text(const std::string& mjcf) {
  const NamedFiles found = look_at_model_text(mjcf);
  require(found.files.empty(), "a text has no files");
  require(found.foreign || file_named_in(mjcf).empty(), "a file that is named is foreign");
}

void check_error(const ModelError& error) {
  require(error.line >= 0 && error.column >= 0, "a place is no negative one");
  require(error.message.find('\n') == error.message.npos, "one line: " + error.message);
  require(error.cure.find('\n') == error.cure.npos, "one line: " + error.cure);
}

void check_model(const std::string& mjcf, const std::string& answer) {
  static CourseOfModel course;
  course.check(mjcf);
  check_text(mjcf);
  check_error(explain_load_error(answer, "models/m.xml"));
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input = mjcourse::text_of_input(data, size), between = "=====\n";
  const std::size_t end = std::min(input.find(between), input.size());
  mjcourse::check_model(input.substr(0, end),
                        input.substr(std::min(end + between.size(), input.size())));
  return 0;
}
