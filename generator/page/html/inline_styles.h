// InlineStyles: style attributes, moved from the elements of a page into a stylesheet of its own.
//
// KaTeX places what it sets with style attributes, and the policy that each page carries
// (`default-src 'self'`) forbids them. So each different style becomes a class; the rules stand in
// no layer and win over all that do, as the attributes did.
#pragma once

#include <map>
#include <string>

namespace mjcourse {

class InlineStyles {
 public:
  // `html` with a class in place of each style attribute.
  std::string take(const std::string& html);

  // The rules of all classes; "" when there are none.
  std::string sheet() const { return sheet_; }

 private:
  const std::string& class_of(const std::string& style);

  std::map<std::string, std::string> classes_;  // by style
  std::string sheet_;
};

}  // namespace mjcourse
