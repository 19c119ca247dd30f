// Runs a fuzzer's entry once over each file in the folders named, where libFuzzer is not linked.
// Words that begin with `-` are libFuzzer's, and not for us.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

#include "fuzz.h"

int main(int count, char** words) {
  int files = 0;
  for (int i = 1; i < count; ++i) {
    if (std::string_view(words[i]).starts_with('-')) continue;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(words[i])) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      std::cerr << entry.path().string() << '\n';  // the last one is the one that failed
      LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++files;
    }
  }
  std::cerr << files << " files\n";
  return files > 0 ? 0 : 1;
}
