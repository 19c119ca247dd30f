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

TEST(HighlighterTest, AnUnknownLanguageIsEscapedText) {
  Highlighter highlighter(bundle("highlight"));
  EXPECT_EQ(highlighter.highlight("a < b && \"c\"", "brainfuck"),
            "a &lt; b &amp;&amp; &quot;c&quot;");
  EXPECT_EQ(highlighter.highlight("int <x>", "plaintext"), "int &lt;x&gt;");
}

}  // namespace mjcourse
