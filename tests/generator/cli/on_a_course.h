// A small course, and commands that are run on it.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "cli/ran.h"

namespace mjcourse {

class OnACourse : public testing::Test {
 protected:
  OnACourse() {
    setenv("MJCOURSE_ASSETS", MJCOURSE_ASSETS, 1);
    write("content/course.yaml", "title: C\nlevels: [{folder: 1-a, title: A, lessons: [1.1-x]}]\n");
    write("content/1-a/1.1-x.md", "---\ntitle: First\n---\nText.\n");
  }
  ~OnACourse() override { unsetenv("MJCOURSE_ASSETS"); }

  void write(const std::string& path, const std::string& bytes) const {
    write_file(folder_.path() / path, bytes);
  }
  // Without the time it took, which is never the same.
  Ran on_course(std::vector<std::string> arguments) const {
    arguments.insert(arguments.end(), {"--course", folder_.path().string()});
    Ran result = ran(arguments);
    if (const std::size_t comma = result.out.find(" errors, "); comma != std::string::npos) {
      result.out.erase(comma + 7, result.out.find('\n', comma) - comma - 7);
    }
    return result;
  }

  TemporaryFolder folder_;
};

}  // namespace mjcourse
