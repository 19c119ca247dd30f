// A site of two lessons, of which nothing was evaluated, as the writers of its pages see it.
#pragma once

#include <utility>

#include "base/files.h"
#include "page/site_data.h"
#include "reading_of.h"

namespace mjcourse {

struct SiteOf {
  SiteOf() {
    course.title = "C";
    course.levels.push_back({"1-a", "A", "1", {0, 1}});
    add("---\ntitle: One\nminutes: 20\n---\n", "content/1-a/1.1-x.md");
    add("---\ntitle: Two\nformerly: [1.2-old]\n---\n", "content/1-a/1.2-y.md");
    evaluation.lessons.resize(2);
  }
  void add(const std::string& text, const std::string& path) {
    course.add(std::move(reading_of_file(text, path).lesson.value()));
  }

  Course course;
  Evaluation evaluation;
  DiskFiles assets{MJCOURSE_ASSETS};
  SiteData data{course, evaluation, assets, assets, nlohmann::json::object(), {}};
};

}  // namespace mjcourse
