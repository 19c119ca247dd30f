#include "lesson/blocks/read_commands.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace mjcourse {
namespace {

namespace fs = std::filesystem;

bool leaves_the_course(const fs::path& path) {
  return path.is_absolute() || std::ranges::find(path, "..") != path.end();
}

// The words of `files="…"`; one that leads out of the course is reported and left out.
std::vector<LocatedText> read_files(const LocatedText& option, Reading& reading) {
  std::vector<LocatedText> files;
  const std::string& text = option.text;
  for (std::size_t end = 0, begin = 0; (begin = text.find_first_not_of(' ', end)) != text.npos;) {
    end = std::min(text.find(' ', begin), text.size());
    LocatedText file = option.part(begin, end);
    if (leaves_the_course(file.text)) {
      reading.error("E-commands-file", file.span(), "commands see files of the course alone",
                    "name them as seen from the course's folder: `files=\"examples/NAME.cpp\"`");
    } else {
      files.push_back(std::move(file));
    }
  }
  return files;
}

}  // namespace

bool is_commands(const Fence& fence) {
  return fence.words().size() > 1 && fence.words()[0].text == "sh" &&
         fence.words()[1].text == "run";
}

Commands read_commands(Fence& fence, Reading& reading) {
  Commands commands{fence.body(),
                    read_files(fence.option("files").value_or(LocatedText{}), reading)};
  commands.span = fence.span();
  commands.seconds =
      fence.number("timeout", reading, fences::kMostSeconds).value_or(commands.seconds);
  if (commands.code.text.find_first_not_of(" \n") == std::string::npos) {
    reading.error("E-commands-empty", fence.span(), "this fence has no commands",
                  "write at least one, as a reader would type it");
  }
  fence.finish("sh run", fences::kCommands, reading);
  return commands;
}

}  // namespace mjcourse
