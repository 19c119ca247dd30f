// New files and the line that lists them, written together: all of them, or none.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace mjcourse {

// Why a command that makes files made none, and what to do about it.
struct Refusal {
  int code;  // the exit code: kWrongUsage, or kCourseErrors where the folder is what is in the way
  std::string message, cure;
};

// The command line is wrong, or the folder is in the way.
tl::unexpected<Refusal> wrong_words(std::string message, std::string cure);
tl::unexpected<Refusal> wrong_course(std::string message, std::string cure);

struct NewFile {
  std::string path;  // relative to the course
  std::string bytes;
  std::optional<std::string> before = {};  // what it holds now; nothing: it must not be there
};

// Refuses a path of which a part is longer than 230 bytes, or a disk may not take it.
tl::expected<void, Refusal> check_length(const std::filesystem::path& path);

// Writes them below `root`, in their order. None is left where one of them is there already, or is
// not as it was.
tl::expected<void, Refusal> write_new_files(const std::filesystem::path& root,
                                            const std::vector<NewFile>& files);

// "mjcourse: …" and the cure, to stderr; gives the exit code.
int tell(const Refusal& refusal);
// "wrote …" of each, to stdout.
void tell(const std::vector<NewFile>& files);

}  // namespace mjcourse
