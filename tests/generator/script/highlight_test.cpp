#include "script/highlight.h"

#include <gtest/gtest.h>

#include "bundle.h"

namespace mjcourse {

TEST(HighlighterTest, MarksWhatTheLanguageKnows) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("int x = 1;  // <one>", "cpp"),
            "<span class=\"hljs-type\">int</span> x = <span class=\"hljs-number\">1</span>;  "
            "<span class=\"hljs-comment\">// &lt;one&gt;</span>");
  for (const char* language :
       {"c", "xml", "json", "javascript", "bash", "cmake", "yaml", "python"}) {
    EXPECT_NE(highlighter.highlight("<a b=\"1\"/> if 1 \"x\": #", language).find("<span"),
              std::string::npos)
        << language;
  }
}

TEST(HighlighterTest, WhatHasSeveralPartsHasSeveralClasses) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("def f(): 'a' & 1", "python"),
            "<span class=\"hljs-keyword\">def</span> "
            "<span class=\"hljs-title function_\">f</span>(): "
            "<span class=\"hljs-string\">&#x27;a&#x27;</span> &amp; "
            "<span class=\"hljs-number\">1</span>");
}

TEST(HighlighterTest, SetsALessonsFencesInTheirOwnLanguages) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("```cpp unchecked\nint x;\n```\n", "lesson"),
            "<span class=\"hljs-meta\">```cpp unchecked\n</span>"
            "<span class=\"language-cpp\"><span class=\"hljs-type\">int</span> x;\n</span>"
            "<span class=\"hljs-meta\">```</span>\n");
  const std::string json = highlighter.highlight("```quiz\n{\"id\": 1}\n```\n*a*", "lesson");
  EXPECT_NE(json.find("<span class=\"hljs-attr\">&quot;id&quot;</span>"), std::string::npos)
      << json;
  EXPECT_NE(json.find("<span class=\"hljs-emphasis\">*a*</span>"), std::string::npos) << json;
}

TEST(HighlighterTest, LeavesALessonsFormulasAlone) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("$a_1 b_2$, $5 and $6, \\$1 of \\$", "lesson"),
            "<span class=\"hljs-string\">$a_1 b_2$</span>, $5 and $6, \\$1 of \\$");
}

TEST(HighlighterTest, AnUnknownLanguageIsEscapedText) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("a < b && \"c\"", "brainfuck"),
            "a &lt; b &amp;&amp; &quot;c&quot;");
  EXPECT_EQ(highlighter.highlight("int <x>", "plaintext"), "int &lt;x&gt;");
}

}  // namespace mjcourse
