#include "evaluate/work_message.h"

#include <algorithm>
#include <utility>

#include "cache/cbor.h"
#include "evaluate/codec/blobs_of.h"
#include "evaluate/codec/result_json.h"
#include "evaluate/result_fits.h"

namespace mjcourse {

using nlohmann::json;

namespace {

json binary_of(const std::string& bytes) {
  return json::binary({bytes.begin(), bytes.end()});
}

std::string bytes_in(const json& value) {
  const json::binary_t& bytes = value.get_binary();
  return {bytes.begin(), bytes.end()};
}

}  // namespace

#define MJCOURSE_FIELDS NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE
MJCOURSE_FIELDS(Span, begin, end)
MJCOURSE_FIELDS(Place, file, line, column, width, excerpt, excerpt_column)
MJCOURSE_FIELDS(Note, message, place)
void to_json(json& value, const Edit& edit) {
  value = {{"file", edit.file}, {"span", edit.span}, {"what", edit.what}};
  value["text"] = binary_of(edit.text);
  value["before"] = edit.before ? binary_of(*edit.before) : json();
}

void from_json(const json& value, Edit& edit) {
  value.at("file").get_to(edit.file);
  value.at("span").get_to(edit.span);
  value.at("what").get_to(edit.what);
  edit.text = bytes_in(value.at("text"));
  if (!value.at("before").is_null()) edit.before = bytes_in(value.at("before"));
}
MJCOURSE_FIELDS(Diagnostic, id, severity, place, message, detail, notes, cure, edit)
MJCOURSE_FIELDS(Finding, results, seconds, model_page, diagnostics)
MJCOURSE_FIELDS(WorkQuestion, models, page, text, block, what, reports)
MJCOURSE_FIELDS(WorkAnswer, whole, finding, looked_at, traced, failure)
#undef MJCOURSE_FIELDS

namespace {

template <typename Message>
std::optional<Message> message_in(const json& value) {
  try {
    return value.get<Message>();
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

bool is_of_course(const std::filesystem::path& path) {
  return path.is_relative() && std::ranges::count(path, "..") == 0;
}

// A file of the course, what a program told, or what of the system a film is made with.
bool may_look_at(const std::string& name) {
  return is_of_course(name) || (name.starts_with("/usr/") && is_of_course(name.substr(1)));
}

// A picture beside the lessons that another is to be held against is all that such tasks propose.
bool may_propose(const Diagnostic& diagnostic) {
  const auto& edit = diagnostic.edit;
  return !edit || (edit->file.starts_with("content/") && edit->file.ends_with(".png") &&
                   is_of_course(edit->file) && !edit->span);
}

// Can it be drawn below its line? The printer takes its numbers as they are.
bool can_be_drawn(const Place& place) {
  constexpr int most = 1 << 28;    // no file that is read has longer lines
  constexpr int behind = 1 << 20;  // columns; a line of kilobytes is cut
  const auto is_number = [](int number) { return number >= 0 && number <= most; };
  if (!is_number(place.line) || !is_number(place.column) || !is_number(place.width)) return false;
  const int index = place.column - place.excerpt_column;
  return is_number(place.excerpt_column) && (place.column == 0 || (index >= 0 && index <= behind));
}

bool can_be_shown(const Diagnostic& diagnostic) {
  const bool is_known =
      diagnostic.severity == Severity::error || diagnostic.severity == Severity::warning;
  return is_known && can_be_drawn(diagnostic.place) &&
         std::ranges::all_of(diagnostic.notes,
                             [](const Note& note) { return can_be_drawn(note.place); });
}

// Bytes go beside the results, which only have their hashes.
json bytes_of(Finding finding) {
  json bytes = json::object();
  for (const Blob* blob : blobs_of(finding)) {
    if (!blob->empty()) bytes[blob->hash()] = binary_of(blob->bytes());
  }
  return bytes;
}

// False where some are missing.
bool take_bytes(Finding& finding, const json& bytes) {
  for (Blob* blob : blobs_of(finding)) {
    if (blob->empty()) continue;
    const auto found = bytes.find(blob->hash());
    if (found == bytes.end() || !found->is_binary()) return false;
    Blob taken(bytes_in(*found));
    if (taken.hash() != blob->hash()) return false;
    *blob = std::move(taken);
  }
  return true;
}

}  // namespace

std::string encode(const WorkQuestion& question) {
  return to_cbor(question);
}

std::string encode(const WorkAnswer& answer) {
  json value = answer;
  value["bytes"] = bytes_of(answer.finding);
  return to_cbor(value);
}

std::optional<WorkQuestion> decode_question(std::string_view bytes) {
  const std::optional<json> value = from_cbor(bytes);
  return value ? message_in<WorkQuestion>(*value) : std::nullopt;
}

std::optional<WorkAnswer> decode_answer(std::string_view bytes, const Task& task,
                                        const std::filesystem::path& root) {
  const std::optional<json> value = from_cbor(bytes);
  if (!value) return std::nullopt;
  auto answer = message_in<WorkAnswer>(*value);
  if (!answer || !value->contains("bytes")) return std::nullopt;
  Finding& finding = answer->finding;
  if (!take_bytes(finding, value->at("bytes")) || !fits(task, finding, root) ||
      !std::ranges::all_of(answer->looked_at, may_look_at) ||
      !std::ranges::all_of(finding.diagnostics, can_be_shown) ||
      !std::ranges::all_of(finding.diagnostics, may_propose)) {
    return std::nullopt;
  }
  return answer;
}

}  // namespace mjcourse
