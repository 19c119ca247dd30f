#include "lsp/prose_place.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

using Kind = ProsePlace::Kind;

struct Case {
  const char* before;
  Kind kind;
  const char* of;
  const char* part;
};

class ProsePlaceTest : public testing::TestWithParam<Case> {};

TEST_P(ProsePlaceTest, IsNamed) {
  const auto place = prose_place(GetParam().before, false);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->kind, GetParam().kind);
  EXPECT_EQ(place->of, GetParam().of);
  EXPECT_EQ(place->part, GetParam().part);
}

INSTANTIATE_TEST_SUITE_P(
    All, ProsePlaceTest,
    testing::Values(Case{"```", Kind::fence, "", ""}, Case{"> ```la", Kind::fence, "", "la"},
                    Case{"```cpp file=exa", Kind::file, "", "exa"},
                    Case{"```cpp snippet model=sw", Kind::model, "", "sw"},
                    Case{"```text output=", Kind::program, "", ""},
                    Case{"```cpp sni", Kind::option, "cpp ", "sni"},
                    Case{"```cpp file=examples/a.cpp ", Kind::option, "cpp file=examples/a.cpp ",
                         ""},
                    Case{"```cpp args=\"1 2\" exp", Kind::option, "cpp args=\"1 2\" ", "exp"},
                    Case{"```xml mjcf expect=e", Kind::choice, "xml mjcf expect", "e"},
                    Case{"see [it](1.", Kind::link, "", "1."},
                    Case{"see [it](1.3#an", Kind::heading, "1.3", "an"},
                    Case{"see [it](#", Kind::heading, "", ""},
                    Case{"a [model](model:sw", Kind::model, "", "sw"},
                    Case{"[f](api:mj_st", Kind::api, "", "mj_st"},
                    Case{"a [[rigid bo", Kind::term, "", "rigid bo"},
                    Case{"it has `{sw", Kind::source, "", "sw"},
                    Case{"it has `x` and `{swing} model.n", Kind::value, "swing", "model.n"},
                    Case{"> [!no", Kind::callout, "", "no"}));

TEST(ProsePlace, IsNothingElsewhere) {
  for (const char* before : {"", "text", "see [it](1.3)", "a [[term]] is", "a `span", "a `{x}` is",
                             "```cpp args=\"a mo", "[x](1.3 \"ti", "[[term|sho"}) {
    EXPECT_FALSE(prose_place(before, false)) << before;
  }
  EXPECT_FALSE(prose_place("a[[", true));
}

}  // namespace
}  // namespace mjcourse
