#include "physics/model_files.h"

#include <mujoco/mujoco.h>
#include <strings.h>
#include <tinyxml2.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "base/beneath.h"
#include "base/files.h"
#include "physics/browser_view.h"

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

// The site has a model's files under their own names, and readers open them there. A browser runs
// what is in a page, a drawing or a script, and MuJoCo takes a height field or a texture, or MJCF
// with the right comments, by any name.
constexpr const char* kMjcfEndings[] = {".xml", ".mjcf", ".urdf"};
constexpr const char* kAssetEndings[] = {"",     ".png", ".stl", ".obj", ".msh",
                                         ".skn", ".bin", ".dat", ".hf",  ".hfield"};

template <typename Endings>
bool ends_as(const Endings& endings, const std::string& file) {
  const std::string ending = lower_case(fs::path(last_part(file)).extension().string());
  return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

constexpr off_t kMostMjcf = 16 << 20;  // that a person wrote; an asset may be larger

// What is known of the file at `path` beneath `root`; nothing where it is not there or refused.
std::optional<struct stat> status_in(const fs::path& root, const fs::path& path) {
  const auto name = name_beneath(root, path);
  const auto status = name ? Beneath(root).status(*name) : tl::unexpected(name.error());
  return status && S_ISREG(status->st_mode) ? std::optional(*status) : std::nullopt;
}

// MJCF beneath `root`; "" where it cannot be had.
std::string small_text(const fs::path& root, const fs::path& path) {
  const auto status = status_in(root, path);
  if (!status || status->st_size > kMostMjcf) return "";
  return read_beneath(root, path).value_or("");
}

// The first bytes of a file beneath `root`; "" where it cannot be had.
std::string beginning_of(const fs::path& root, const fs::path& path) {
  const auto name = name_beneath(root, path);
  const auto file = name ? Beneath(root).file(*name) : tl::unexpected(name.error());
  std::string bytes(kLookedAt, '\0');
  const ssize_t n = file ? read(file->descriptor.get(), bytes.data(), bytes.size()) : 0;
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  return bytes;
}

// Every server knows what `.xml` is. Others are XML for a browser where their first bytes say so,
// or else it could take one for a page.
std::optional<ModelError> fault_of_text(const std::string& path, const std::string& text) {
  if (!lower_case(path).ends_with(".xml") && !text.starts_with("<?xml ")) {
    return ModelError{path, 1, 0, "a model's file that is not named .xml says first that it is XML",
                      "begin it with `<?xml version=\"1.0\"?>`, or name it .xml"};
  }
  return fault_for_browsers(path, text);
}

// Each may include the next, and is walked through within it.
constexpr std::size_t kMostIncludes = 500;

// Reads MJCF in document order, with each include in its place.
class SourceWalk {
 public:
  // `folder` lies in `root`, beneath which all is read.
  SourceWalk(fs::path root, fs::path folder) : root_(std::move(root)), folder_(std::move(folder)) {}

  void enter(const std::string& path) {
    if (std::find(texts_.begin(), texts_.end(), path) != texts_.end()) return;  // in a circle
    if (texts_.size() == kMostIncludes) {
      if (!broken_) {
        broken_ =
            ModelError{current_, 0, 0,
                       "the model includes more than " + std::to_string(kMostIncludes) + " files",
                       "put parts of it into one"};
      }
      return;
    }
    XMLDocument document;
    const std::string text = small_text(root_, path);
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
      if (!current_.empty() && !broken_) broken_ = broken_include(path, document);
      return;
    }
    texts_.push_back(path);
    const std::string outer = std::exchange(current_, path);
    if (!for_browsers_) for_browsers_ = fault_of_text(path, text);
    walk_document(document);
    current_ = outer;
  }

  void walk_document(const XMLDocument& document) {
    if (document.RootElement() != nullptr) walk(*document.RootElement());
  }

  void walk(const XMLElement& element) {
    const std::string name = element.Name();
    note_infinite(element);
    if (strcasecmp(name.c_str(), "include") == 0) {
      if (const char* file = element.Attribute("file")) {
        const std::string path = (folder_ / file).string();
        const bool again = std::find(texts_.begin(), texts_.end(), path) != texts_.end();
        includes_.push_back({Folder::meshes, file, current_, element.GetLineNum(), again});
        enter(path);
      }
      return;
    }
    if (name == "robot") strip_ = true;  // URDF, which has other defaults
    if (name == "compiler") read_settings(element);
    for (const Naming& naming : kNamings) {
      const char* file = element.Attribute(naming.attribute);
      if (name != naming.element || file == nullptr || *file == '\0') continue;
      named_.push_back({naming.folder, file, current_, element.GetLineNum()});
    }
    for (const XMLElement* child = element.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      walk(*child);
    }
  }

  const std::vector<std::string>& texts() const { return texts_; }

  // Where a file is named, by an element of the file `by`.
  struct Name {
    Folder folder;
    std::string file, by;
    int line;
    bool again = false;  // included a second time
  };
  const std::vector<Name>& includes() const { return includes_; }
  const std::vector<Name>& named() const { return named_; }
  const std::optional<ModelError>& infinite() const { return infinite_; }
  // The first that a browser would make more of than a text.
  const std::optional<ModelError>& for_browsers() const { return for_browsers_; }
  // The first include that MuJoCo cannot read, of which it would tell no place.
  const std::optional<ModelError>& broken() const { return broken_; }

  // Where MuJoCo reads it from, once all settings are known. An absolute path on the right takes
  // the place of what is left of it, as in MuJoCo.
  fs::path path_of_include(const Name& name) const { return folder_ / name.file; }
  fs::path path_of_asset(const Name& name) const {
    const fs::path& inside = name.folder == Folder::meshes ? meshes_ : textures_;
    return folder_ / inside / (strip_ ? last_part(name.file) : name.file);
  }

  std::vector<std::string> assets() const {
    std::vector<std::string> paths;
    for (const Name& name : named_) {
      const fs::path path = path_of_asset(name);
      if (status_in(root_, path)) paths.push_back(path.string());
    }
    return paths;
  }

 private:
  // The file at `path`, which the last of includes_ names, is not well-formed or not there.
  ModelError broken_include(const std::string& path, const XMLDocument& document) const {
    if (status_in(root_, path)) {
      return explain_load_error(std::string("XML parse error :\n") + document.ErrorStr(), path);
    }
    const Name& name = includes_.back();
    const auto below = [&](const fs::path& file) {
      return file.lexically_relative(root_).lexically_normal().string();
    };
    const fs::path beside = fs::path(name.by).parent_path() / name.file;
    std::string cure = "MuJoCo starts from the folder of the main file, " + below(texts_.front());
    if (status_in(root_, beside)) {
      cure += ": write `" + beside.lexically_relative(folder_).lexically_normal().string() + "`";
    }
    return {name.by, name.line, 0,
            "the file '" + name.file + "' is not there: it is looked for as " + below(path), cure};
  }

  void note_infinite(const XMLElement& element) {
    for (const auto* a = element.FirstAttribute(); a != nullptr && !infinite_; a = a->Next()) {
      std::istringstream words(a->Value());
      for (std::string word; words >> word;) {
        char* end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        if (*end != '\0' || std::isfinite(number) || std::string_view(a->Name()) == "name")
          continue;
        infinite_ = ModelError{current_, a->GetLineNum(), 0,
                               "'" + word + "' is not a finite number", "write a number"};
      }
    }
  }

  void read_settings(const XMLElement& compiler) {
    if (const char* folder = compiler.Attribute("meshdir")) meshes_ = folder;
    if (const char* folder = compiler.Attribute("texturedir")) textures_ = folder;
    if (const char* strip = compiler.Attribute("strippath")) {
      strip_ = std::string_view(strip) == "true";
    }
  }

  fs::path root_;
  fs::path folder_;  // of the main file, for includes too
  fs::path meshes_, textures_;
  bool strip_ = false;
  std::vector<std::string> texts_;
  std::vector<Name> includes_, named_;
  std::optional<ModelError> infinite_, for_browsers_, broken_;
  std::string current_;  // the file that is walked
};

constexpr const char* kBeside = "put it beside the model, or into a folder there";

// What is wrong with a file that a model in `folder` names; nothing where it is one of them, or not
// there, of which MuJoCo tells.
std::optional<FileRefusal> why_foreign(const fs::path& path, const fs::path& root,
                                       const fs::path& folder, const char* cure_outside,
                                       bool is_mjcf) {
  const FileRefusal outside{"lies outside of the folder of the model", cure_outside};
  const Beneath beneath(root);
  const auto name = name_beneath(root, path), inside = name_beneath(root, folder);
  if (!name || !inside) return outside;
  const auto real = beneath.target(*name), real_folder = beneath.target(*inside);
  if (!real) return real.error().is_refused() ? std::optional(outside) : std::nullopt;
  if (!real_folder || !name_beneath("/" + *real_folder, "/" + *real)) return outside;
  const auto status = beneath.status(*name);
  if (!status) return status.error().refusal();
  if (!S_ISREG(status->st_mode)) return refusal_of_no_file();
  if (!is_mjcf || status->st_size <= kMostMjcf) return std::nullopt;
  return FileRefusal{"is larger than 16 MiB", "put a smaller one there"};
}

std::optional<ModelError> find_foreign(const SourceWalk& walk, const std::string& main,
                                       const fs::path& root, const fs::path& folder) {
  const auto refuse_main = [&](const FileRefusal& refusal) {
    return ModelError{main, 0, 0, "the model's file " + refusal.why, refusal.cure};
  };
  const auto beneath = name_beneath(root, main);
  if (const auto refusal = beneath ? DiskFiles(root).refusal(*beneath) : std::nullopt) {
    return refuse_main(*refusal);
  }
  const char* const home = "write it into the models' folder";
  if (const auto refusal = why_foreign(main, root, folder, home, true)) {
    return refuse_main(*refusal);
  }
  const auto refuse = [](const SourceWalk::Name& name, const FileRefusal& refusal) {
    return ModelError{name.by, name.line, 0, "the file '" + name.file + "' " + refusal.why,
                      refusal.cure};
  };
  const auto misnamed = [](const SourceWalk::Name& name, const std::string& right) {
    return ModelError{name.by, name.line, 0,
                      "the file '" + name.file + "' has an ending that no file of a model has",
                      "name it as what it is, such as " + right};
  };
  for (const SourceWalk::Name& name : walk.includes()) {
    const auto why = why_foreign(walk.path_of_include(name), root, folder, kBeside, true);
    if (why) return refuse(name, *why);
    if (!ends_as(kMjcfEndings, name.file)) return misnamed(name, "x.xml");
    if (!name.again) continue;
    return ModelError{name.by, name.line, 0, "the file '" + name.file + "' is included again",
                      "MuJoCo includes a file once"};
  }
  if (walk.broken()) return walk.broken();
  for (const SourceWalk::Name& name : walk.named()) {
    const auto why = why_foreign(walk.path_of_asset(name), root, folder, kBeside, false);
    if (why) return refuse(name, *why);
    if (!ends_as(kAssetEndings, name.file)) return misnamed(name, "x.png, x.stl, x.obj or x.bin");
    if (begins_like_page(beginning_of(root, walk.path_of_asset(name)))) {
      return ModelError{name.by, name.line, 0,
                        "the file '" + name.file + "' begins as a page for a browser does",
                        "name a mesh, a texture or a height field"};
    }
  }
  return walk.for_browsers();
}

std::vector<std::string> files_of(const SourceWalk& walk) {
  std::vector<std::string> files = walk.texts();
  const std::vector<std::string> assets = walk.assets();
  files.insert(files.end(), assets.begin(), assets.end());
  return files;
}

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

SourceWalk walk_text(const std::string& mjcf) {
  XMLDocument document;
  SourceWalk walk{fs::path(), fs::path()};
  if (document.Parse(mjcf.data(), mjcf.size()) == tinyxml2::XML_SUCCESS) {
    walk.walk_document(document);
  }
  return walk;
}

std::optional<SourceWalk::Name> first_name_in(const SourceWalk& walk) {
  if (walk.includes().empty() && walk.named().empty()) return std::nullopt;
  return walk.includes().empty() ? walk.named().front() : walk.includes().front();
}

}  // namespace

bool is_name_of_asset(const std::string& name) {
  return ends_as(kAssetEndings, name);
}

bool is_inert(const fs::path& course, const std::string& path) {
  if (is_name_of_asset(path)) return !begins_like_page(beginning_of(course, course / path));
  const std::string text = small_text(course, course / path);
  return ends_as(kMjcfEndings, path) && !fault_of_text(path, text);
}

tl::expected<ModelSources, std::string> find_model_sources(const fs::path& root,
                                                           const std::string& name) {
  const std::string path = (root / name).string();
  SourceWalk walk(root, fs::path(path).parent_path());
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

NamedFiles look_at_model_files(const fs::path& course, const std::string& name) {
  const fs::path root = fs::absolute(course);
  const std::string path = (root / name).string();
  const fs::path folder = fs::path(path).parent_path();
  NamedFiles found;
  SourceWalk walk(root, folder);
  walk.enter(path);
  // Models in folders share what lies in `models`.
  const fs::path first = *fs::path(name).begin();
  found.foreign = find_foreign(walk, path, root, first == name ? root : root / first);
  found.infinite = walk.infinite();
  found.files = files_of(walk);
  return found;
}

NamedFiles look_at_model_text(const std::string& mjcf) {
  const SourceWalk walk = walk_text(mjcf);
  NamedFiles found;
  found.infinite = walk.infinite();
  if (const auto name = first_name_in(walk)) {
    found.foreign =
        ModelError{"", name->line, 0,
                   "a model inside a lesson cannot name files; this one names " + name->file,
                   "put the model into a file of its own, models/NAME.xml"};
  }
  return found;
}

std::string file_named_in(const std::string& mjcf) {
  const std::optional<SourceWalk::Name> name = first_name_in(walk_text(mjcf));
  return name ? name->file : "";
}

}  // namespace mjcourse
