#include "report/other_tools.h"

#include <filesystem>

namespace mjcourse {

std::string course_path(const std::string& folder, const std::string& file) {
  return (std::filesystem::path(folder) / file).lexically_normal().generic_string();
}

std::string message_with_cure(const Diagnostic& diagnostic) {
  std::string text = diagnostic.message;
  if (!diagnostic.detail.empty()) {
    text += "\n" + diagnostic.detail.substr(0, diagnostic.detail.find_last_not_of('\n') + 1);
  }
  if (!diagnostic.cure.empty()) text += "\ncure: " + diagnostic.cure;
  return text;
}

}  // namespace mjcourse
