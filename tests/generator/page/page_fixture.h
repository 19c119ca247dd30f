// The page of a lesson in a course of two, written with the results that a test gives it.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/files.h"
#include "findings/lab_scripts.h"
#include "page/blocks/page_writer.h"
#include "reading_of.h"
#include "script/script_bundles.h"

namespace mjcourse {

class PageWriterTest : public testing::Test {
 protected:
  PageWriterTest() {
    const DiskFiles assets(MJCOURSE_ASSETS);
    std::map<std::string, std::string> sources;
    for (const std::string& name : assets.list("templates")) {
      sources[name.substr(0, name.rfind('.'))] = assets.read("templates/" + name).value();
    }
    templates_.emplace(script_bundle(assets, "templates"), sources);
    highlighter_.emplace(script_bundle(assets, "highlight"));
  }

  // For the lesson with this body.
  PageWriter writer(const std::string& markdown) {
    course_.lessons.clear();
    course_.add(std::move(reading_of(markdown).lesson.value()));
    course_.add(
        std::move(reading_of_file("---\ntitle: Two\n---\n## There\n", "content/1-a/1.2-y.md")
                      .lesson.value()));
    for (std::size_t i = 0; i < course_.lessons[0].blocks.size(); ++i) {
      const auto* lab = std::get_if<Lab>(&course_.lessons[0].blocks[i]);
      const auto result = results_.of_block.find(i);
      if (lab != nullptr && result != results_.of_block.end()) {
        pass_scripts(*lab, std::get<LabResult>(result->second));
      }
    }
    return {
        course_, course_.lessons[0], results_, {*templates_, *highlighter_, manifest_, styles_}};
  }

  // As the guard passes what needs none.
  static void pass_scripts(const Lab& lab, LabResult& result) {
    for (const auto& [text, kind] : scripts_of(lab)) {
      result.scripts[lab_script_key(text->text, kind)] = text->text;
      if (kind != ScriptKind::assignment) continue;
      result.scripts[lab_script_key(text->text, ScriptKind::value)] = text->text;
    }
  }

  std::string body(const std::string& markdown) {
    PageWriter first = writer(markdown);
    std::string html = first.body();
    contents_ = first.contents();
    EXPECT_EQ(writer(markdown).body(), html);
    return html;
  }

  std::optional<Templates> templates_;
  std::optional<Highlighter> highlighter_;
  nlohmann::json manifest_ = nlohmann::json::object();
  InlineStyles styles_;
  Course course_;
  LessonResults results_;
  nlohmann::json contents_;
};

}  // namespace mjcourse
