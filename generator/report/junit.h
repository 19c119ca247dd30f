// What was checked as JUnit's XML, which GitLab, Jenkins and their like show as tests.
#pragma once

#include <string>
#include <vector>

#include "report/diagnostic.h"

namespace mjcourse {

// One thing that was looked at.
struct TestCase {
  std::string name;
  int line = 0;              // of the suite's file; 0 for none
  double seconds = 0;        // measured
  std::string skipped = {};  // why; empty where it was not
  // What is wrong, where the name says so in short, and the diagnostic's id; empty where it is not.
  std::string failure = {}, id = {};
};

struct TestSuite {
  std::string name;
  std::string file;
  std::vector<TestCase> cases;
};

// A whole document.
std::string junit_xml(const std::vector<TestSuite>& suites, double seconds);

}  // namespace mjcourse
