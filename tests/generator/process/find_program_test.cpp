#include "process/find_program.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class FindProgram : public testing::Test {
 protected:
  FindProgram() : path_(std::getenv("PATH")) {}
  ~FindProgram() override { setenv("PATH", path_.c_str(), 1); }

  void look_in(const std::string& path) const { setenv("PATH", path.c_str(), 1); }
  fs::path make(const std::string& name, mode_t mode) const {
    write_file(folder_.path() / name, "#!/bin/sh\n");
    chmod((folder_.path() / name).c_str(), mode);
    return folder_.path() / name;
  }
  std::string in(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;

 private:
  std::string path_;
};

TEST_F(FindProgram, GivesTheFirstOfPath) {
  make("a/other", 0755);
  const fs::path first = make("b/tool", 0755);
  make("c/tool", 0755);
  look_in(in("a") + ":" + in("missing") + ":" + in("b") + ":" + in("c"));
  EXPECT_EQ(find_program("tool"), first);
  EXPECT_EQ(find_program("nothing"), fs::path());
}

TEST_F(FindProgram, PassesOverWhatCannotBeRun) {
  make("a/tool", 0644);
  fs::create_directories(folder_.path() / "b/tool");
  const fs::path last = make("c/tool", 0755);
  look_in(in("a") + ":" + in("b") + ":" + in("c"));
  EXPECT_EQ(find_program("tool"), last);
}

TEST_F(FindProgram, FindsNoneWithoutAPath) {
  unsetenv("PATH");
  EXPECT_EQ(find_program("sh"), fs::path());
  look_in("");
  EXPECT_EQ(find_program("sh"), fs::path());
}

}  // namespace
}  // namespace mjcourse
