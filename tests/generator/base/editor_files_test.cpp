#include "base/editor_files.h"

#include <gtest/gtest.h>

namespace mjcourse {
namespace {

TEST(EditorFiles, AreToldByTheirNames) {
  for (const char* name : {".style.css.swp", "style.css.swp", "style.css~", "#style.css#",
                           ".#style.css", ".style.css.kate-swp", "4913", ".DS_Store", ".vscode"}) {
    EXPECT_TRUE(is_of_editor(name)) << name;
  }
  for (const char* name :
       {"style.css", "page.hbs", "a~b.css", "4913.css", "swp", "a#b", "#1.png", "#"}) {
    EXPECT_FALSE(is_of_editor(name)) << name;
  }
}

}  // namespace
}  // namespace mjcourse
