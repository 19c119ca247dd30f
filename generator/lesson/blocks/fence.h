// Fence: a fenced code block as the author wrote it: its words, its options, its body.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lesson/blocks/fence_kinds.h"
#include "lesson/syntax/located_text.h"
#include "lesson/syntax/markdown.h"
#include "lesson/syntax/reading.h"

namespace mjcourse {

class Fence {
 public:
  // `node` is a code block of the document that stands in `source` line for line.
  Fence(cmark_node* node, const SourceText& source);

  // The opening fence with its info string.
  Span span() const { return span_; }
  // False when the lesson ended before the fence did, or when another fence opens inside it.
  bool closed() const { return closed_; }
  // An indented block, which has no fence at all.
  bool indented() const { return indented_; }
  // The words of the info string that are no options: "lab simlab" → lab, simlab.
  const std::vector<LocatedText>& words() const { return words_; }
  // The first of them; empty where there is none.
  std::string kind() const { return words_.empty() ? "" : words_[0].text; }
  const LocatedText& body() const { return body_; }

  // The value of `name=value` or `name="value"`; nothing when it is not there.
  std::optional<LocatedText> option(const std::string& name) const;
  // The value of `name=5`; nothing (reported) when it is no number, less than 0 or more than
  // `most`.
  std::optional<double> number(const std::string& name, Reading& reading,
                               double most = std::numeric_limits<double>::max()) const;
  // Is the word `name` among those behind the kind's own?
  bool flag(const std::string& name) const;
  // Report its second word, which makes no kind with the first as `known` ones do; false where it
  // has none.
  bool refuse_second_word(const std::vector<std::string>& known, Reading& reading) const;
  // Report what stands behind the words of `kind` ("lab simlab") and is none of its options.
  void finish(const std::string& kind, std::span<const FenceOption> options,
              Reading& reading) const;

 private:
  struct Option {
    LocatedText name, value;
  };
  void read_info(const SourceText& source, std::size_t begin, std::size_t end);
  void read_body(cmark_node* node, const SourceText& source);

  Span span_;
  bool closed_ = true;
  bool indented_ = false;
  std::vector<LocatedText> words_;
  std::vector<Option> options_;
  LocatedText body_;
};

}  // namespace mjcourse
