// DeepFolder: folders in each other, more than this process can have files open meanwhile.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>

#include "base/descriptor.h"

namespace mjcourse {

class DeepFolder {
 public:
  explicit DeepFolder(const std::filesystem::path& place) {
    std::filesystem::create_directories(place);
    Descriptor folder(open(place.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
    for (int i = 0; i < 200; ++i) {
      EXPECT_EQ(mkdirat(folder.get(), "d", 0700), 0);
      folder = Descriptor(openat(folder.get(), "d", O_PATH | O_DIRECTORY | O_CLOEXEC));
    }
    EXPECT_EQ(getrlimit(RLIMIT_NOFILE, &before_), 0);
    const rlimit few{100, before_.rlim_max};
    EXPECT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  }
  ~DeepFolder() { setrlimit(RLIMIT_NOFILE, &before_); }
  DeepFolder(const DeepFolder&) = delete;
  DeepFolder& operator=(const DeepFolder&) = delete;

 private:
  rlimit before_{};
};

}  // namespace mjcourse
