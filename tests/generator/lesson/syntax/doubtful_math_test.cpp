#include "lesson/syntax/doubtful_math.h"

#include <gtest/gtest.h>

#include <string>

namespace mjcourse {
namespace {

// Of the first two dollars of `text`.
bool doubtful(const std::string& text) {
  const std::size_t begin = text.find('$'), end = text.find('$', begin + 1);
  return is_doubtful_math(begin > 0 ? text[begin - 1] : '\0',
                          text.substr(begin + 1, end - begin - 1), text.substr(end + 1));
}

TEST(DoubtfulMath, IsMoneyAndVariables) {
  for (const char* text : {"US$5–$7; (5$)", "$HOME/$USER", "${HOME}/$USER", "$5 and more to 7$",
                           "cd $A:$PATH", "$1,000 for each of 3$", "a$b$", "$PATH; US$ 5",
                           "$cost and more$", "$`x^2`$", "$`\\pi`$", "–$7; (5$ each"}) {
    EXPECT_TRUE(doubtful(text)) << text;
  }
}

TEST(DoubtfulMath, IsNoFormulaThatGoesOnWithAWord) {
  for (const char* text : {"$x$",
                           "($x$)",
                           "the $n$th",
                           "three $x$s",
                           "$k$-fold",
                           "$k$fold",
                           "$n$'s",
                           "H$_2$O",
                           "10$^{-3}$",
                           "5$\\mu$m",
                           "$5 \\text{ of them}$",
                           "设$x$为",
                           "$2$ and",
                           "$5 m$",
                           "_$x$_",
                           "$dx dy$",
                           "$mgh x$",
                           "$max(a, b)$",
                           "_$x$_",
                           "$[0, 1)$",
                           "$2 (a + b)$"}) {
    EXPECT_FALSE(doubtful(text)) << text;
  }
}

}  // namespace
}  // namespace mjcourse
