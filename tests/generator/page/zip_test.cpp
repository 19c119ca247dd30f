#include "page/zip.h"

#include <gtest/gtest.h>
#include <zip.h>

namespace mjcourse {
namespace {

// Two bytes of `bytes`, the lower first.
int number_at(const std::string& bytes, std::size_t at) {
  return static_cast<unsigned char>(bytes.at(at)) | static_cast<unsigned char>(bytes.at(at + 1))
                                                        << 8;
}

// What libzip reads as the file `path` of the archive `bytes`.
std::string unpacked(const std::string& bytes, const std::string& path) {
  zip_t* archive = zip_open_from_source(
      zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr), ZIP_RDONLY, nullptr);
  zip_file_t* file = zip_fopen(archive, path.c_str(), 0);
  if (file == nullptr) return "no " + path;
  std::string text(1000, '\0');
  text.resize(static_cast<std::size_t>(zip_fread(file, text.data(), text.size())));
  zip_fclose(file);
  zip_discard(archive);
  return text;
}

TEST(Zip, GivesBackWhatWasPutIn) {
  const std::string bytes = zip_of({{"b/two.txt", std::string(900, 'x')}, {"a/ü.txt", "one\n"}});
  EXPECT_EQ(unpacked(bytes, "a/ü.txt"), "one\n");
  EXPECT_EQ(unpacked(bytes, "b/two.txt"), std::string(900, 'x'));
  EXPECT_LT(bytes.size(), 400u);
}

TEST(Zip, HasNothingThatAnotherDayOrPlaceWouldChange) {
  const std::string bytes = zip_of({{"b", "two\n"}, {"a", ""}});
  std::string names;
  int entries = 0;
  const auto look = [&](const std::string& mark, std::size_t date, std::size_t name_size,
                        std::size_t extra, std::size_t name) {
    for (std::size_t at = 0; (at = bytes.find(mark, at)) != bytes.npos; at += mark.size()) {
      ++entries;
      EXPECT_EQ(number_at(bytes, at + date - 2), 0) << "midnight";
      EXPECT_EQ(number_at(bytes, at + date), 0x21) << "January 1, 1980";
      EXPECT_EQ(number_at(bytes, at + extra), 0);
      names += bytes.substr(at + name, static_cast<std::size_t>(number_at(bytes, at + name_size)));
    }
  };
  look("PK\x03\x04", 12, 26, 28, 30);
  look("PK\x01\x02", 14, 28, 30, 46);
  EXPECT_EQ(entries, 4);
  EXPECT_EQ(names, "abab");
}

}  // namespace
}  // namespace mjcourse
