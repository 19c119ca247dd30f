#include "toolchain/containment.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

class ContainmentTest : public testing::Test {
 protected:
  ContainmentTest() {
    write_file(model_, "a model\n");
    for (const fs::path& path : {course_, course_ / "models"}) {
      fs::permissions(path, fs::perms(0755));
    }
    fs::permissions(model_, fs::perms(0644));
    fs::create_directory(run_);
  }
  Sandbox of_program() const { return program_sandbox("/bin/sh", run_, {}, course_); }
  // Whether a program reads the model.
  bool reads() const {
    Command command;
    command.arguments = {"/bin/sh", "-c", "read x <" + model_.string() + " && echo $x"};
    command.folder = run_;
    command.sandbox = of_program();
    return run(command).out == "a model\n";
  }

  const TemporaryFolder folder_;
  const fs::path course_ = folder_.path() / "course", run_ = folder_.path() / "run";
  const fs::path model_ = course_ / "models" / "a.xml";
};

// Else it would read root's files in the system's folders too.
TEST_F(ContainmentTest, KeepsNoRightOfRootForACourseThatAllMayRead) {
  EXPECT_FALSE(of_program().reads_all);
  EXPECT_FALSE(compiler_sandbox(run_, {course_}).reads_all);
  EXPECT_TRUE(reads());
}

TEST_F(ContainmentTest, LetsACourseBeClosedToOthers) {
  if (geteuid() == 0 && sandbox_level().landlock == 0) GTEST_SKIP() << "not without Landlock";
  fs::permissions(course_, fs::perms(0700));
  EXPECT_TRUE(of_program().reads_all);
  EXPECT_TRUE(compiler_sandbox(run_, {course_ / "models"}).reads_all);
  EXPECT_TRUE(reads());
  fs::permissions(course_, fs::perms(0755));
  fs::permissions(model_, fs::perms(0600));
  EXPECT_TRUE(of_program().reads_all);
  EXPECT_TRUE(reads());
}

TEST_F(ContainmentTest, KeepsNoRightOfRootForCommands) {
  fs::permissions(course_, fs::perms(0700));
  EXPECT_FALSE(commands_sandbox(folder_.path() / "commands.sh", run_).reads_all);
}

TEST_F(ContainmentTest, FindsNoFaultInACourseWithoutModels) {
  fs::remove_all(course_ / "models");
  EXPECT_FALSE(of_program().reads_all);
}

}  // namespace
}  // namespace mjcourse
