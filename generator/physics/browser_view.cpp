#include "physics/browser_view.h"

#include <algorithm>
#include <utility>

#include "base/utf8.h"
#include "base/xml_reader.h"

namespace mjcourse {
namespace {

class ModelReader : public XmlReader {
 public:
  ModelReader(std::string path, const std::string& bytes)
      : XmlReader(bytes), path_(std::move(path)), bytes_(bytes) {}

  std::optional<ModelError> fault() {
    if (const auto bad = find_invalid_utf8(bytes_)) {
      refuse(*bad, "a model's file is in UTF-8", "save it in UTF-8");
      return std::move(fault_);
    }
    if (const auto mistake = read(); mistake && !fault_) {
      if (mistake->is_of_prefix) {
        refuse(mistake->span.begin, "a model has no `:` in a name", "write the name without it");
      } else {
        refuse(mistake->span.begin, "this is no XML for a browser: " + mistake->message,
               mistake->cure.empty() ? "correct it, or remove it" : mistake->cure);
      }
    }
    return std::move(fault_);
  }

 private:
  void refuse(std::size_t at, const std::string& message, const std::string& cure) {
    if (fault_) return;  // what was begun is told to its end
    const auto lines = std::count(bytes_.begin(), bytes_.begin() + static_cast<long>(at), '\n');
    fault_ = ModelError{path_, static_cast<int>(lines) + 1, 0, message, cure};
    stop();
  }

  void refuse_instruction(std::size_t at) {
    refuse(at, "a model has no instructions for a browser",
           "remove this line; the first may be `<?xml version=\"1.0\"?>`");
  }

  void declare(const XmlDeclaration& declaration) override {
    if (declaration.is_plain()) return;
    refuse(here().begin, "a model's file is XML 1.0 in UTF-8, and says nothing else",
           "save it in UTF-8; its first line may be `<?xml version=\"1.0\"?>`");
  }
  void instruct() override { refuse_instruction(here().begin); }
  void type(bool /*defines*/) override {
    refuse_instruction(bytes_.rfind("<!DOCTYPE", here().begin));
  }

  void begin(const XmlElement& element) override {
    if (!element.namespaces.empty()) {
      const std::string& prefix = element.namespaces.front().prefix;
      const std::string name = prefix.empty() ? "xmlns" : "xmlns:" + prefix;
      return refuse(place_of_attribute(name).begin,
                    "a model has no namespaces, as by the attribute '" + readable(name) + "'",
                    "remove the attribute: MuJoCo does not look at it");
    }
    if (!element.name.prefix.empty()) return refuse_name(here().begin, element.name);
    for (const XmlAttribute& attribute : element.attributes) {
      if (attribute.name.prefix.empty()) continue;
      return refuse_name(place_of_attribute(attribute.name.text()).begin, attribute.name);
    }
  }

  void refuse_name(std::size_t at, const XmlName& name) {
    refuse(at, "a model has no `:` in a name, as in '" + readable(name.text()) + "'",
           "write the name without it");
  }

  std::string path_;
  const std::string& bytes_;
  std::optional<ModelError> fault_;
};

}  // namespace

std::optional<ModelError> fault_for_browsers(const std::string& path, const std::string& text) {
  return ModelReader(path, text).fault();
}

bool begins_like_page(std::string_view beginning) {
  if (beginning.starts_with("\xEF\xBB\xBF")) beginning.remove_prefix(3);
  const std::size_t at = beginning.find_first_not_of(" \t\r\n\f");
  if (at == beginning.npos || beginning[at] != '<' || at + 1 == beginning.size()) return false;
  const char next = beginning[at + 1];
  return is_letter(next) || next == '!' || next == '?';
}

}  // namespace mjcourse
