#include "toolchain/driver_steps.h"

#include <gtest/gtest.h>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/subprocess.h"
#include "toolchain/toolchain.h"

namespace mjcourse {
namespace {

TEST(DriverSteps, AreTheLinesInQuotes) {
  EXPECT_EQ(parse_driver_steps("Debian clang version 16.0.6\n"
                               "Target: x86_64-pc-linux-gnu\n"
                               " (in-process)\n"
                               " \"/usr/bin/clang\" \"-cc1\" \"-D\" \"A=\\\"\\\\\\$\"\n"
                               " \"/usr/bin/ld\" \"\"\n"),
            (std::vector<std::vector<std::string>>{{"/usr/bin/clang", "-cc1", "-D", "A=\"\\$"},
                                                   {"/usr/bin/ld", ""}}));
}

TEST(DriverSteps, AreAScriptWithItsNamesLeftOpen) {
  EXPECT_EQ(shell_script({{"cc", "/w/a.cpp", "-o", "/w/a-1.o"}, {"ld", "it's", "/w/a", "/w/b"}},
                         {"/w/a", "/w/a.cpp", "/w"}),
            "'cc' ''\"$2\"'' '-o' ''\"$1\"'-1.o' &&\n"
            "'ld' 'it'\\''s' ''\"$1\"'' ''\"$3\"'/b'");
}

// A name that a shell would take apart, or run.
TEST(DriverSteps, DoWhatTheDriverDoes) {
  const TemporaryFolder folder;
  const auto compile = [&](const std::string& name, int exit_code) {
    const std::string binary = folder.path() / name, source = binary + ".cpp";
    write_file(source, "int main() { return " + std::to_string(exit_code) + "; }\n");
    const std::vector<std::string> command = without_driver(
        {"clang++-16", source, "-o", binary}, {source, binary, folder.path()}, folder.path(), {});
    EXPECT_EQ(command.front(), "sh");
    EXPECT_TRUE(succeeded(run_tool(command, folder.path(), {})));
    Command program;
    program.arguments = {binary};
    EXPECT_EQ(run(program).code, exit_code);
    return command.at(2);
  };
  const std::string script = compile("plain", 3);
  EXPECT_EQ(compile("it's `id` $HOME \"7\"", 5), script);
}

TEST(DriverSteps, StayWithTheDriverThatDoesNotTell) {
  const TemporaryFolder folder;
  const std::vector<std::string> command{"clang++-16", "missing.cpp", "-o", "missing"};
  EXPECT_EQ(without_driver(command, {"missing.cpp"}, folder.path(), {}), command);
}

}  // namespace
}  // namespace mjcourse
