#include "lsp/editor_diagnostics.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/utf8.h"
#include "course/course.h"

namespace mjcourse {
namespace {

using nlohmann::json;

// The bytes of the first `count` characters.
std::size_t bytes_of_characters(std::string_view text, int count) {
  std::size_t at = 0;
  for (; count > 0 && at < text.size(); --count) at = character_end(text, at);
  return at;
}

json location_of(const Place& place, const OpenDocuments& documents, Units units) {
  return {{"uri", documents.uri_of(place.file)}, {"range", json_of(range_of(place, units))}};
}

// What a terminal shows in several parts stands in one text here.
std::string message_of(const Diagnostic& diagnostic) {
  std::string text = diagnostic.message;
  if (!diagnostic.detail.empty()) text += "\n" + diagnostic.detail;
  for (const Note& note : diagnostic.notes) {
    if (note.place.file.empty()) text += "\nnote: " + note.message;
  }
  if (!diagnostic.cure.empty()) text += "\ncure: " + diagnostic.cure;
  return text;
}

}  // namespace

TextRange range_of(const Place& place, Units units) {
  if (place.line == 0) return {};
  const int index = place.column - place.excerpt_column;
  const std::size_t begin = bytes_of_characters(place.excerpt, index);
  const std::size_t end = bytes_of_characters(place.excerpt, index + place.width);
  const std::string_view line = place.excerpt;
  // What is cut off counts as ASCII, which so long a line mostly is.
  const int cut = place.excerpt_column - 1;
  return {{place.line - 1, cut + count_units(line.substr(0, begin), units)},
          {place.line - 1, cut + count_units(line.substr(0, end), units)}};
}

std::string file_of(const Diagnostic& diagnostic) {
  return diagnostic.place.file.empty() ? kCoursePath : diagnostic.place.file;
}

json json_of(const Diagnostic& diagnostic, const OpenDocuments& documents, Units units) {
  json related = json::array();
  for (const Note& note : diagnostic.notes) {
    if (note.place.file.empty()) continue;
    related.push_back(
        {{"location", location_of(note.place, documents, units)}, {"message", note.message}});
  }
  json one{{"range", json_of(range_of(diagnostic.place, units))},
           {"severity", diagnostic.severity == Severity::error ? 1 : 2},
           {"code", diagnostic.id},
           {"source", "mjcourse"},
           {"message", message_of(diagnostic)}};
  if (!related.empty()) one["relatedInformation"] = std::move(related);
  return one;
}

void EditorDiagnostics::publish(const Diagnostics& diagnostics, Units units) {
  std::map<std::string, json> by_file;
  // That nothing is wrong with what is open is worth knowing too.
  for (const std::string& file : documents_.names()) by_file[file] = json::array();
  for (const std::string& file : std::exchange(marked_, {})) by_file[file] = json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    const std::string file = file_of(diagnostic);
    by_file[file].push_back(json_of(diagnostic, documents_, units));
    marked_.insert(file);
  }
  for (auto& [file, all] : by_file) {
    connection_.notify("textDocument/publishDiagnostics",
                       {{"uri", documents_.uri_of(file)}, {"diagnostics", std::move(all)}});
  }
}

}  // namespace mjcourse
