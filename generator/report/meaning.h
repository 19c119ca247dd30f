// What the diagnostics mean, each by its id: what `mjcourse explain E-output-differs` prints, and
// what SARIF gives along.
//
// There is one text of it, a page of the author guide (content/guide/A.9-what-mjcourse-says.md),
// which is built into the program. Its sections `### ID` are the meanings: paragraphs, and behind
// them two items `- wrong: …` and `- right: …`. A test holds the ids against those in our sources.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/terminal_style.h"

namespace mjcourse {

struct Meaning {
  std::string_view id;    // "E-output-differs"
  std::string_view text;  // Markdown, without the heading
};

// Each is a view of `page`, in its order.
std::vector<Meaning> read_meanings(std::string_view page);

// Those that the program has inside.
const std::vector<Meaning>& meanings();

// Null where there is no diagnostic of that id.
const Meaning* meaning_of(std::string_view id);

// Does `text` look like an id, known or not: "E-…", "W-…"?
bool is_like_id(std::string_view text);

// The text as it is printed in a terminal, ending in a newline.
std::string format_for_terminal(const Meaning& meaning, const TerminalStyle& style = {});

// The text without Markdown's marks: a line for each paragraph and each item. Code keeps its
// backticks; a link becomes its words, and the lesson that it leads to.
std::string plain_text_of(const Meaning& meaning);

}  // namespace mjcourse
