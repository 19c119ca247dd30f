// What an editor writes to the language server, of any bytes: headers, messages, and a document
// that is opened and changed by them.
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/utf8.h"
#include "fuzz.h"
#include "lsp/file_uri.h"
#include "lsp/messages.h"
#include "lsp/open_documents.h"
#include "require.h"

namespace mjcourse {
namespace {

using nlohmann::json;

void change(OpenDocuments& documents, const json& params) {
  const auto changes = OpenDocuments::read_changes(params.at("contentChanges"));
  documents.change("content/1-a/1.1-x.md", changes, Units::utf16);
  documents.change("models/m.xml", changes, Units::utf8);
}

void check_document(const OpenDocuments& documents, const std::string& name) {
  const auto text = documents.text(name);
  require(text && !find_invalid_utf8(text->text()), "a document is UTF-8: " + name);
  for (const Units units : {Units::utf8, Units::utf16}) {
    for (const std::size_t offset :
         {std::size_t{0}, text->text().size() / 2, text->text().size()}) {
      const std::size_t at = character_start(text->text(), offset);
      if (at > 0 && text->text()[at - 1] == '\r') continue;  // within the end of a line
      require(offset_of(*text, point_of(*text, at, units), units) == at, "a place is found again");
    }
  }
}

void check_uri(const json& message) {
  const auto uri = message.find("uri");
  if (uri == message.end() || !uri->is_string()) return;
  const auto path = path_of(uri->get_ref<const std::string&>());
  require(!path || path_of(uri_of(*path)) == path, "an address leads to its path");
}

void take(const std::string& body, OpenDocuments& documents) {
  const json message = parse_message(body);
  if (message.is_discarded() || !message.is_object()) return;
  const json copy = message;  // as an answer has its question's id
  std::ostringstream out;
  write_message(out, copy.dump(-1, ' ', false, json::error_handler_t::replace));
  std::istringstream in(out.str());
  require(read_message(in).has_value(), "what is written can be read");
  check_uri(message);
  try {
    change(documents, message.value("params", json::object()));
  } catch (const json::exception&) {
    return;  // parameters of the wrong kind are refused
  }
  for (const std::string& name : documents.names()) check_document(documents, name);
}

}  // namespace
}  // namespace mjcourse

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(mjcourse::text_of_input(data, size));
  mjcourse::OpenDocuments documents("/course");
  documents.open("content/1-a/1.1-x.md", "---\ntitle: T\n---\n\nÜber 😀 𝐱.\r\nEnd");
  documents.open("models/m.xml", "");
  while (const auto body = mjcourse::read_message(in)) mjcourse::take(*body, documents);
  return 0;
}
