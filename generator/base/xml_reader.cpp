#include "base/xml_reader.h"

#include <expat.h>

#include <algorithm>
#include <array>
#include <new>
#include <utility>
#include <vector>

#include "base/utf8.h"

namespace mjcourse {
namespace {

// Between the parts of a name. No XML can have it, not even by its number.
constexpr char kPart = '\1';
constexpr std::string_view kXmlSpaces = " \t\r\n";

// "space|local|prefix", "space|local" or "local".
XmlName name_of(std::string_view parts) {
  const std::size_t first = parts.find(kPart);
  if (first == parts.npos) return {"", parts, ""};
  const std::size_t second = parts.find(kPart, first + 1);
  if (second == parts.npos) return {parts.substr(0, first), parts.substr(first + 1), ""};
  return {parts.substr(0, first), parts.substr(first + 1, second - first - 1),
          parts.substr(second + 1)};
}

bool is_in_reference(std::string_view before) {
  const std::size_t from = before.find_last_of("&;<>\"' \t\r\n");
  return from != before.npos && before[from] == '&';
}

// Why the character at `at` cannot stand there.
XmlMistake wrong_character(const std::string& bytes, std::size_t at) {
  const std::string_view before = std::string_view(bytes).substr(0, at);
  const Span span{at, at + 1};
  if (before.ends_with("--")) {
    return {{at - 2, at}, "a comment has `--` in it", "write a single `-`"};
  }
  if (before.ends_with("]]") && bytes[at] == '>') {
    return {{at - 2, at + 1}, "a text has `]]>` in it", "write `]]&gt;`"};
  }
  if (is_in_reference(before)) {
    const std::size_t from = before.rfind('&');
    return {{from, from + 1}, "an `&` begins no character", "write `&amp;`"};
  }
  if (bytes[at] == '<') return {span, "a `<` begins nothing", "write `&lt;`"};
  const std::string character = bytes.substr(at, character_end(bytes, at) - at);
  return {span, "`" + readable(character) + "` cannot stand here", ""};
}

bool is_known_to_xml(std::string_view reference) {
  constexpr std::array known{"&amp", "&lt", "&gt", "&quot", "&apos"};
  return reference.starts_with("&#") || std::ranges::count(known, reference) > 0;
}

// The first reference from `at` on that only HTML knows: one in a value is told of at its tag.
XmlMistake unknown_reference(const std::string& bytes, std::size_t at) {
  std::string name;
  for (std::size_t from = bytes.find('&', at); from != bytes.npos;
       from = bytes.find('&', from + 1)) {
    name = bytes.substr(from, bytes.find(';', from) - from);
    if (is_known_to_xml(name)) continue;
    return {{from, from + name.size() + 1},
            "it has no character `" + readable(name) + ";`",
            "write the character itself, or its number, as `&#160;`"};
  }
  return {{at, at + 1}, "it has no such character", "write the character itself"};
}

// A mistake that expat found, in our words.
XmlMistake mistake_of(XML_Error error, const std::string& bytes, std::size_t at) {
  const Span span{at, at + 1};
  switch (error) {
    case XML_ERROR_NO_ELEMENTS:
    case XML_ERROR_UNCLOSED_TOKEN:
    case XML_ERROR_UNCLOSED_CDATA_SECTION:
      return {span, "its end is missing", "close what is open, or save it again"};
    case XML_ERROR_SYNTAX:
      return {span, "it begins with no element", "remove what is before the first one"};
    case XML_ERROR_INVALID_TOKEN:
      return wrong_character(bytes, at);
    case XML_ERROR_TAG_MISMATCH:
      return {span, "another element is to be closed first", "close each element where it ends"};
    case XML_ERROR_DUPLICATE_ATTRIBUTE:
      return {span, "an element has this attribute twice", "remove one of the two"};
    case XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
      return {span, "something follows its first element", "put all of it into one element"};
    case XML_ERROR_UNDEFINED_ENTITY:
      return unknown_reference(bytes, at);
    case XML_ERROR_BAD_CHAR_REF:
      return {span, "no character has this number", "remove it"};
    case XML_ERROR_MISPLACED_XML_PI:
      return {span, "`<?xml` is not its beginning", "remove what is before it"};
    case XML_ERROR_UNBOUND_PREFIX:
      return {span, "a prefix in this element stands for nothing",
              "declare it, as by `xmlns:xlink=\"http://www.w3.org/1999/xlink\"`, or remove it",
              true};
    default:
      return {span, XML_ErrorString(error), ""};
  }
}

}  // namespace

std::string XmlName::text() const {
  return prefix.empty() ? std::string(local) : std::string(prefix) + ":" + std::string(local);
}

bool XmlDeclaration::is_plain() const {
  return version == "1.0" && (encoding.empty() || lower_case_utf8(encoding) == "utf-8");
}

struct XmlReader::Calls {
  static XmlReader& reader(void* user) { return *static_cast<Calls*>(user)->of; }

  static void declare(void* user, const char* version, const char* encoding, int /*standalone*/) {
    reader(user).declare({version, encoding == nullptr ? "" : encoding});
  }
  static void declare_namespace(void* user, const char* prefix, const char* space) {
    static_cast<Calls*>(user)->namespaces.push_back(
        {prefix == nullptr ? "" : prefix, space == nullptr ? "" : space});
  }
  static void begin(void* user, const char* name, const char** attribute) {
    auto& calls = *static_cast<Calls*>(user);
    calls.attributes.clear();
    for (; *attribute != nullptr; attribute += 2) {
      calls.attributes.push_back({name_of(attribute[0]), attribute[1]});
    }
    calls.of->begin({name_of(name), calls.attributes, calls.namespaces});
    calls.namespaces.clear();
  }
  static void end(void* user, const char* /*name*/) { reader(user).end(); }
  static void text(void* user, const char* text, int size) {
    reader(user).text({text, static_cast<std::size_t>(size)});
  }
  static void instruct(void* user, const char* /*target*/, const char* /*text*/) {
    reader(user).instruct();
  }
  static void type(void* user, const char* /*name*/, const char* /*system*/,
                   const char* /*publics*/, int defines) {
    reader(user).type(defines != 0);
  }

  XmlReader* of = nullptr;
  std::vector<XmlAttribute> attributes;
  std::vector<XmlNamespace> namespaces;
};

void XmlReader::Free::operator()(XML_ParserStruct* parser) const {
  XML_ParserFree(parser);
}

XmlReader::XmlReader(const std::string& bytes)
    : bytes_(bytes), parser_(XML_ParserCreateNS("UTF-8", kPart)) {
  if (!parser_) throw std::bad_alloc();
  XML_SetReturnNSTriplet(parser_.get(), 1);
  XML_SetXmlDeclHandler(parser_.get(), Calls::declare);
  XML_SetStartNamespaceDeclHandler(parser_.get(), Calls::declare_namespace);
  XML_SetElementHandler(parser_.get(), Calls::begin, Calls::end);
  XML_SetCharacterDataHandler(parser_.get(), Calls::text);
  XML_SetProcessingInstructionHandler(parser_.get(), Calls::instruct);
  XML_SetStartDoctypeDeclHandler(parser_.get(), Calls::type);
}

XmlReader::~XmlReader() = default;

std::optional<XmlMistake> XmlReader::read() {
  Calls calls{this, {}, {}};
  XML_SetUserData(parser_.get(), &calls);
  const auto size = static_cast<int>(bytes_.size());
  if (XML_Parse(parser_.get(), bytes_.data(), size, XML_TRUE) == XML_STATUS_OK) return std::nullopt;
  const XML_Error error = XML_GetErrorCode(parser_.get());
  if (error == XML_ERROR_ABORTED) return std::nullopt;  // stop()
  if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
  return mistake_of(error, bytes_, here().begin);
}

Span XmlReader::here() const {
  // It is -1 where there is nothing at all.
  const auto at =
      static_cast<std::size_t>(std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser_.get())));
  return {at, at + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()))};
}

Span XmlReader::place_of_attribute(std::string_view name) const {
  const Span tag = here();
  const std::string_view text = std::string_view(bytes_).substr(0, tag.end);
  // Each is a name, `=` and a value in quotes, with spaces between.
  std::size_t at = text.find_first_of(kXmlSpaces, tag.begin);
  while ((at = text.find_first_not_of(kXmlSpaces, at)) != text.npos) {
    const std::size_t end = text.find_first_of("= \t\r\n/>", at);
    if (text.substr(at, end - at) == name) return {at, end};
    const std::size_t quote = text.find_first_of("\"'", end);
    if (quote == text.npos) break;
    at = text.find(text[quote], quote + 1) + 1;
  }
  return tag;
}

void XmlReader::stop() {
  XML_StopParser(parser_.get(), XML_FALSE);
}

}  // namespace mjcourse
