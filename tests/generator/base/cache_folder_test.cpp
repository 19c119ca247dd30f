#include "base/cache_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {
namespace {

// Sets a variable, or unsets it where `value` is empty, for as long as it lives.
class Variable {
 public:
  Variable(const char* name, const std::string& value) : name_(name) {
    if (const char* former = std::getenv(name)) former_ = former;
    set(value.empty() ? std::nullopt : std::optional(value));
  }
  ~Variable() { set(former_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const std::optional<std::string>& value) const {
    value ? setenv(name_, value->c_str(), 1) : unsetenv(name_);
  }

  const char* name_;
  std::optional<std::string> former_;
};

std::optional<std::filesystem::path> folder_with(const std::string& cache,
                                                 const std::string& home) {
  const Variable of_cache("XDG_CACHE_HOME", cache), of_home("HOME", home);
  return user_cache_folder();
}

TEST(CacheFolder, IsWhereTheUserSaysAndIsMade) {
  const TemporaryFolder folder;
  const std::string cache = folder.path() / "cache", home = folder.path() / "home";
  EXPECT_EQ(folder_with(cache, home), folder.path() / "cache/mjcourse");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "cache/mjcourse"));
  EXPECT_FALSE(std::filesystem::exists(home));
}

TEST(CacheFolder, IsInTheHomeWithoutThat) {
  const TemporaryFolder folder;
  EXPECT_EQ(folder_with("", folder.path()), folder.path() / ".cache/mjcourse");
  EXPECT_EQ(folder_with("relative", folder.path()), folder.path() / ".cache/mjcourse");
}

TEST(CacheFolder, IsNoneWithoutAHomeThatCanBeWritten) {
  EXPECT_EQ(folder_with("", ""), std::nullopt);
  EXPECT_EQ(folder_with("relative", "relative"), std::nullopt);
  const TemporaryFolder folder;
  write_file(folder.path() / "file", "");
  EXPECT_EQ(folder_with(folder.path() / "file", folder.path()), std::nullopt);
}

}  // namespace
}  // namespace mjcourse
