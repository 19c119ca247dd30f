#include "lesson/front_matter.h"

#include <string_view>

#include "lesson/json/yaml_map.h"

namespace mjcourse {
namespace {

constexpr const char* kId = "E-front-matter";

}  // namespace

std::optional<Span> find_front_matter(Reading& reading) {
  const SourceText& source = reading.source();
  if (source.text().starts_with("\uFEFF")) {
    reading.error(kId, {0, 3}, "the file begins with a byte-order mark",
                  "save it as UTF-8 without one");
    return std::nullopt;
  }
  if (source.line(1) != "---") {
    reading.error(kId, {0, source.line(1).size()}, "a lesson begins with its front matter",
                  "begin the file with `---`, `title: …`, `---`");
    return std::nullopt;
  }
  for (int line = 2; line <= source.line_count(); ++line) {
    if (source.line(line) == "---") return Span{source.line_start(2), source.line_start(line)};
  }
  reading.error(kId, {0, 3}, "the front matter that opens here is never closed",
                "end it with a line `---`");
  return std::nullopt;
}

FrontMatter read_title_and_summary(Span span, LessonReader& reader) {
  FrontMatter front;
  const LocatedText text = located(reader.source(), span);
  const std::optional<YAML::Node> yaml = parse_yaml(text, "front matter", kId, reader.reading());
  if (!yaml) return front;
  YamlMap map(*yaml, "front matter", kId, text, reader.reading());
  front.title = map.required_string("title");
  front.summary = reader.fragment(map.string("summary"));
  map.finish();
  return front;
}

FrontMatter read_front_matter(Span span, LessonReader& reader) {
  FrontMatter front;
  Reading& reading = reader.reading();
  const LocatedText text = located(reader.source(), span);
  const std::optional<YAML::Node> yaml = parse_yaml(text, "front matter", kId, reading);
  if (!yaml) return front;
  YamlMap map(*yaml, "front matter", kId, text, reading);
  front.title = map.required_string("title");
  front.summary = reader.fragment(map.string("summary"));
  front.minutes = map.count("minutes");
  front.prerequisites = map.strings("prerequisites");
  for (const LocatedText& objective : map.strings("objectives")) {
    front.objectives.push_back(reader.fragment(objective));
  }
  for (const LocatedText& tag : map.strings("tags")) front.tags.push_back(tag.text);
  front.draft = map.boolean("draft", false);
  front.formerly = map.strings("formerly");
  map.finish();
  return front;
}

}  // namespace mjcourse
