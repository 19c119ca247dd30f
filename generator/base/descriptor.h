// A file descriptor that closes itself.
// Tested by tests/generator/process/launch_news_test.cpp.
#pragma once

#include <filesystem>
#include <string_view>

namespace mjcourse {

class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { reset(); }
  int get() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  int release();
  void reset();

 private:
  int number_;
};

// A call of the system failed on `path`: throws std::system_error with what errno says.
[[noreturn]] void throw_errno(const std::filesystem::path& path);

// Writes all of `bytes`, or throws as throw_errno(path) does.
void write_all(int descriptor, std::string_view bytes, const std::filesystem::path& path);

}  // namespace mjcourse
