// XmlReader: reads XML as a browser does.
//
// A browser shows nothing of a file that is not well-formed, or that uses a namespace's prefix
// without declaring it. A subclass hears what is there, in the file's order. Nothing is loaded, no
// entity has a meaning but XML's own five, and the depth of the elements costs no stack.
// Tested by tests/generator/evaluate/scenes/svg_faults_test.cpp.
// Tested by tests/generator/physics/model_files_test.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/source_text.h"

struct XML_ParserStruct;

namespace mjcourse {

struct XmlName {
  std::string_view space;  // the address of its namespace; "" where it is in none
  std::string_view local, prefix;

  std::string text() const;  // as it is written
};

struct XmlAttribute {
  XmlName name;
  std::string_view value;
};

struct XmlNamespace {
  std::string prefix;  // "" of `xmlns=`
  std::string space;
};

struct XmlElement {
  XmlName name;
  std::span<const XmlAttribute> attributes;  // without its namespaces
  std::span<const XmlNamespace> namespaces;  // those that it declares
};

struct XmlDeclaration {
  std::string version;
  std::string encoding;  // "" where it names none

  // XML 1.0 in UTF-8, as all readers have it without a declaration.
  bool is_plain() const;
};

// Why something is not XML.
struct XmlMistake {
  Span span;
  std::string message;
  std::string cure;           // "" where only what made the file can save it better
  bool is_of_prefix = false;  // one that stands for nothing
};

class XmlReader {
 public:
  // `bytes` are UTF-8, whatever they say of themselves, and stay as long as this does. They are at
  // most 1 GiB.
  explicit XmlReader(const std::string& bytes);
  virtual ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  // Until stop(), or to the first mistake. Once.
  std::optional<XmlMistake> read();

  // What expat calls.
  struct Calls;

 protected:
  virtual void declare(const XmlDeclaration& /*declaration*/) {}
  virtual void begin(const XmlElement& element) = 0;
  virtual void end() {}
  virtual void text(std::string_view /*text*/) {}
  virtual void instruct() {}
  // A `<!DOCTYPE>`; where it `defines` something, entities may follow it.
  virtual void type(bool /*defines*/) {}

  // What is being heard of, as it stands in the file: a whole tag, a whole instruction.
  Span here() const;
  // Where the name of an attribute of the tag begins that is being heard of.
  Span place_of_attribute(std::string_view name) const;
  void stop();

 private:
  struct Free {
    void operator()(XML_ParserStruct* parser) const;
  };

  const std::string& bytes_;
  std::unique_ptr<XML_ParserStruct, Free> parser_;
};

}  // namespace mjcourse
