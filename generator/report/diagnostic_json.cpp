#include "report/diagnostic_json.h"

#include <nlohmann/json.hpp>

namespace mjcourse {
namespace {

nlohmann::json json_of(const Place& place) {
  return {{"file", place.file},
          {"line", place.line},
          {"column", place.column},
          {"width", place.width},
          {"excerpt", place.excerpt}};
}

}  // namespace

nlohmann::json json_of(const Diagnostic& diagnostic) {
  nlohmann::json notes = nlohmann::json::array();
  for (const Note& note : diagnostic.notes) {
    notes.push_back({{"message", note.message}, {"place", json_of(note.place)}});
  }
  return {{"id", diagnostic.id},
          {"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
          {"place", json_of(diagnostic.place)},
          {"message", diagnostic.message},
          {"detail", diagnostic.detail},
          {"notes", std::move(notes)},
          {"cure", diagnostic.cure}};
}

}  // namespace mjcourse
