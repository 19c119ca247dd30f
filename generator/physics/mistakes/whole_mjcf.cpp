#include "physics/mistakes/whole_mjcf.h"

#include <strings.h>
#include <tinyxml2.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

namespace mjcourse {
namespace {

using Read = std::function<std::string(const std::string&)>;

std::string escaped(const char* value) {
  std::string text;
  for (const char* c = value; *c != '\0'; ++c) {
    switch (*c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '"':
        text += "&quot;";
        break;
      case '\n':
        text += ' ';
        break;
      default:
        text += *c;
    }
  }
  return text;
}

class Putter {
 public:
  Putter(std::filesystem::path folder, const Read& read)
      : folder_(std::move(folder)), read_(read) {}

  void put_file(const std::string& file, const std::string& text, bool is_main) {
    tinyxml2::XMLDocument document;
    const bool is_new = files_.insert(file).second;
    const bool parsed = document.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS;
    if (!is_new || !parsed || document.RootElement() == nullptr) return;
    const std::string outer = std::exchange(file_, file);
    if (is_main) {
      put(*document.RootElement());
    } else {
      put_children(*document.RootElement());
    }
    file_ = outer;
  }

  WholeMjcf take() { return std::move(whole_); }

 private:
  void put(const tinyxml2::XMLElement& element) {
    const char* file = element.Attribute("file");
    if (strcasecmp(element.Name(), "include") == 0 && file != nullptr) {
      whole_.includes = true;
      const std::string path = (folder_ / file).string();
      put_file(path, read_(path), false);
      return;
    }
    WholeMjcf::Element found{element.Name(), {}, file_, element.GetLineNum(), parent_};
    if (!whole_.elements.empty()) whole_.text += '\n';
    whole_.text += "<" + found.name;
    for (const auto* a = element.FirstAttribute(); a != nullptr; a = a->Next()) {
      whole_.text += std::string(" ") + a->Name() + "=\"" + escaped(a->Value()) + "\"";
      found.attributes[a->Name()] = a->Value();
    }
    whole_.text += ">";
    whole_.elements.push_back(std::move(found));
    const std::string outer = std::exchange(parent_, element.Name());
    put_children(element);
    parent_ = outer;
    whole_.text += std::string("</") + element.Name() + ">";
  }

  void put_children(const tinyxml2::XMLElement& parent) {
    for (const auto* child = parent.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      put(*child);
    }
  }

  std::filesystem::path folder_;
  const Read& read_;
  WholeMjcf whole_;
  std::set<std::string> files_;
  std::string file_;
  std::string parent_;  // of the elements that are put
};

}  // namespace

WholeMjcf whole_mjcf(const std::string& file, const std::string& text, const Read& read) {
  Putter putter(std::filesystem::path(file).parent_path(), read);
  putter.put_file(file, text, true);
  return putter.take();
}

}  // namespace mjcourse
