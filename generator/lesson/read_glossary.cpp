#include "lesson/read_glossary.h"

#include <algorithm>
#include <utility>

#include "lesson/blocks/lesson_reader.h"
#include "lesson/front_matter.h"
#include "lesson/read_lesson.h"
#include "lesson/syntax/term_syntax.h"

namespace mjcourse {
namespace {

// The line of `node`, from its first character on.
Span line_of(cmark_node* node, const SourceText& source) {
  const int line = cmark_node_get_start_line(node);
  const std::size_t start = source.line_start(line);
  return {start, start + source.line(line).size()};
}

// Fences claim what takes a lesson around it: take them out before they are read.
void refuse_fences(cmark_node* document, Reading& reading) {
  std::vector<cmark_node*> fences;
  cmark_iter* walk = cmark_iter_new(document);
  for (cmark_event_type event; (event = cmark_iter_next(walk)) != CMARK_EVENT_DONE;) {
    cmark_node* node = cmark_iter_get_node(walk);
    if (event == CMARK_EVENT_ENTER && cmark_node_get_type(node) == CMARK_NODE_CODE_BLOCK) {
      fences.push_back(node);
    }
  }
  cmark_iter_free(walk);
  for (cmark_node* fence : fences) {
    reading.error("E-glossary-fence", line_of(fence, reading.source()),
                  "a definition cannot hold a fence",
                  "say it in words, and link to the lesson that shows it");
    cmark_node_free(fence);
  }
}

// Moves what stands below each heading into a term of its own.
class TermCutter {
 public:
  TermCutter(Glossary& glossary, Reading& reading) : glossary_(glossary), reading_(reading) {}

  void run() {
    cmark_node* document = glossary_.page.document.get();
    for (cmark_node* node = cmark_node_first_child(document); node != nullptr;) {
      cmark_node* next = cmark_node_next(node);
      if (cmark_node_get_type(node) == CMARK_NODE_HEADING) {
        if (!begin(node)) break;
      } else if (definition_ != nullptr) {
        cmark_node_append_child(definition_, node);
      }
      node = next;
    }
    finish();
    if (glossary_.terms.empty() && heading_ == nullptr) {
      reading_.error("E-glossary-empty", {0, 3}, "this glossary has no terms",
                     "begin each with a heading, `## Free joint`, and define it below");
    }
  }

 private:
  // False where there is more than is read of a file, as from this heading on.
  bool begin(cmark_node* heading) {
    const std::vector<Heading>& headings = glossary_.page.headings;
    const auto read = std::ranges::find(headings, heading, &Heading::node);
    if (read == headings.end()) return false;
    finish();
    heading_ = heading;
    definition_ = nullptr;
    const Span line = line_of(heading, reading_.source());
    if (cmark_node_get_heading_level(heading) > 2) {
      reading_.error("E-glossary-heading", line, "a definition cannot hold a heading",
                     "a term begins with `##`");
      return true;
    }
    Glossary::Term term;
    term.name = plain_text(heading);
    term.key = term_key(term.name);
    term.id = read->id;
    if (const Glossary::Term* first = glossary_.find(term.key)) {
      reading_.error("E-term-twice", line, "`" + term.name + "` is defined twice",
                     "it was defined as `" + first->name + "` above: make one of the two");
      return true;
    }
    cmark_node_unlink(heading);
    term.heading.reset(heading);
    term.definition.reset(cmark_node_new(CMARK_NODE_DOCUMENT));
    definition_ = term.definition.get();
    glossary_.terms.push_back(std::move(term));
    return true;
  }

  void finish() {
    if (definition_ == nullptr || cmark_node_first_child(definition_) != nullptr) return;
    reading_.error("E-glossary-definition", line_of(heading_, reading_.source()),
                   "`" + glossary_.terms.back().name + "` has no definition",
                   "say below its heading what it is");
  }

  Glossary& glossary_;
  Reading& reading_;
  cmark_node* heading_ = nullptr;
  cmark_node* definition_ = nullptr;  // of the term being filled
};

}  // namespace

const Glossary::Term* Glossary::find(const std::string& key) const {
  const auto found =
      std::find_if(terms.begin(), terms.end(), [&](const Term& term) { return term.key == key; });
  return found == terms.end() ? nullptr : &*found;
}

std::vector<std::string> Glossary::names() const {
  std::vector<std::string> names;
  for (const Term& term : terms) names.push_back(term.name);
  return names;
}

std::optional<Glossary> read_glossary(std::string bytes, Diagnostics& diagnostics,
                                      const Typography& typography) {
  Glossary glossary;
  Lesson& page = glossary.page;
  page.slug = "glossary";
  page.typography = typography;
  page.source = read_source(kGlossaryPath, std::move(bytes), diagnostics);
  if (!page.source) return {};
  Reading reading(*page.source, diagnostics);
  const std::optional<Span> front = find_front_matter(reading);
  if (!front) return std::nullopt;
  LessonReader reader(page, reading);
  page.front = read_title_and_summary(*front, reader);
  page.document = reader.parse(without_front_matter(*page.source, *front), 1);
  refuse_fences(page.document.get(), reading);
  reader.read_document();
  TermCutter(glossary, reading).run();
  return glossary;
}

}  // namespace mjcourse
