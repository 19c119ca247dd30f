// Typesetter: TeX formulas to HTML with MathML beside it, by KaTeX.
//
// Enter with typeset(). Whatever KaTeX doubts is an error with its place: an undefined command, a
// missing brace, and also what LaTeX itself would refuse (a Unicode letter in math). So no page
// ever shows a red formula. The HTML is, byte for byte, what KaTeX gives under Node.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <tl/expected.hpp>

#include "script/engine.h"

namespace mjcourse {

struct MathError {
  std::string message;
  std::size_t offset = 0;  // bytes into the formula; its size when KaTeX expected more
  std::size_t length = 0;  // bytes that are wrong; 0 when only the place is known
  std::string cure;        // "did you mean `\alpha`?"; empty when there is nothing to suggest
};

class Typesetter {
 public:
  // `bundle` is the text of script/typeset.js; `macros` maps `\name` to its TeX.
  explicit Typesetter(const std::string& bundle,
                      const std::map<std::string, std::string>& macros = {});

  // `display` sets the formula on its own lines. A formula's own \gdef ends with it.
  tl::expected<std::string, MathError> typeset(const std::string& tex, bool display);

 private:
  Engine engine_;
  std::string macros_;  // as JSON
};

}  // namespace mjcourse
