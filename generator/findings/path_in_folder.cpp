#include "findings/path_in_folder.h"

namespace mjcourse {

std::string path_in_folder(const std::string& path, const Example& example) {
  const std::string& program = example.file.text;
  for (const std::string& folder :
       {program.substr(0, program.rfind('/') + 1), std::string("examples/")}) {
    if (path.starts_with(folder)) return path.substr(folder.size());
  }
  return path;
}

}  // namespace mjcourse
