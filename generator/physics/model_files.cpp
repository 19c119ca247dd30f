#include "physics/model_files.h"

#include <mujoco/mujoco.h>
#include <strings.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;
using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;

// Which attributes of which elements name files, and the folder they are searched in.
enum class Folder { meshes, textures };
struct Naming {
  const char* element;
  const char* attribute;
  Folder folder;
};
constexpr Naming kNamings[] = {
    {"mesh", "file", Folder::meshes},          {"mesh", "filename", Folder::meshes},
    {"hfield", "file", Folder::meshes},        {"skin", "file", Folder::meshes},
    {"texture", "file", Folder::textures},     {"texture", "fileright", Folder::textures},
    {"texture", "fileleft", Folder::textures}, {"texture", "fileup", Folder::textures},
    {"texture", "filedown", Folder::textures}, {"texture", "filefront", Folder::textures},
    {"texture", "fileback", Folder::textures}};

std::string last_part(const std::string& path) {
  return path.substr(path.find_last_of("/\\") + 1);
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Reads MJCF in document order, with each include in its place.
class SourceWalk {
 public:
  explicit SourceWalk(fs::path folder) : folder_(std::move(folder)) {}

  void enter(const std::string& path) {
    XMLDocument document;
    if (document.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) return;
    texts_.push_back(path);
    if (document.RootElement() != nullptr) walk(*document.RootElement());
  }

  void walk(const XMLElement& element) {
    const std::string name = element.Name();
    if (strcasecmp(name.c_str(), "include") == 0) {
      if (const char* file = element.Attribute("file")) {
        first_ = first_.empty() ? file : first_;
        enter((folder_ / file).string());
      }
      return;
    }
    if (name == "robot") strip_ = true;  // URDF, which has other defaults
    if (name == "compiler") read_settings(element);
    for (const Naming& naming : kNamings) {
      const char* file = element.Attribute(naming.attribute);
      if (name != naming.element || file == nullptr || *file == '\0') continue;
      first_ = first_.empty() ? file : first_;
      named_.emplace_back(naming.folder, file);
    }
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      walk(*child);
    }
  }

  const std::vector<std::string>& texts() const { return texts_; }
  const std::string& first() const { return first_; }

  // Where MuJoCo reads the assets from, once all settings are known.
  std::vector<std::string> assets() const {
    std::vector<std::string> paths;
    for (const auto& [folder, file] : named_) {
      const fs::path& inside = folder == Folder::meshes ? meshes_ : textures_;
      // An absolute path on the right takes the place of what is left of it, as in MuJoCo.
      const fs::path path = folder_ / inside / (strip_ ? last_part(file) : file);
      std::error_code error;
      if (fs::is_regular_file(path, error)) paths.push_back(path.string());
    }
    return paths;
  }

 private:
  void read_settings(const XMLElement& compiler) {
    if (const char* folder = compiler.Attribute("meshdir")) meshes_ = folder;
    if (const char* folder = compiler.Attribute("texturedir")) textures_ = folder;
    if (const char* strip = compiler.Attribute("strippath")) {
      strip_ = std::string_view(strip) == "true";
    }
  }

  fs::path folder_;  // of the main file, for includes too
  fs::path meshes_, textures_;
  bool strip_ = false;
  std::vector<std::string> texts_;
  std::vector<std::pair<Folder, std::string>> named_;
  std::string first_;
};

// Adds `paths` to `files`; gives what is wrong with their names. `taken` has the names of all
// files, with the path of each.
std::string add(const std::vector<std::string>& paths, std::map<std::string, std::string>& files,
                std::map<std::string, std::string>& taken) {
  for (const std::string& path : paths) {
    const std::string normal = fs::path(path).lexically_normal().string();
    const auto [other, is_new] = taken.emplace(lower_case(last_part(normal)), normal);
    if (!is_new && other->second != normal) {
      return "two files of the model are named " + last_part(normal) +
             ", and the page finds a file by its name alone";
    }
    files[last_part(normal)] = normal;
  }
  return "";
}

}  // namespace

tl::expected<ModelSources, std::string> find_model_sources(const std::string& path) {
  SourceWalk walk(fs::path(path).parent_path());
  walk.enter(path);
  ModelSources sources;
  sources.main = last_part(path);
  std::map<std::string, std::string> taken;
  std::string wrong = add(walk.texts(), sources.texts, taken);
  if (wrong.empty()) wrong = add(walk.assets(), sources.assets, taken);
  if (!wrong.empty()) return tl::unexpected(wrong);
  if (taken.size() >= mjMAXVFS) {
    return tl::unexpected("the model has " + std::to_string(taken.size()) +
                          " files; in the page MuJoCo has room for " +
                          std::to_string(mjMAXVFS - 1));
  }
  return sources;
}

std::string file_named_in(const std::string& mjcf) {
  XMLDocument document;
  SourceWalk walk{fs::path()};
  if (document.Parse(mjcf.data(), mjcf.size()) == tinyxml2::XML_SUCCESS) {
    walk.walk(*document.RootElement());
  }
  return walk.first();
}

}  // namespace mjcourse
