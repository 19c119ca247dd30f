// The folder of a page's compiler that gives one answer to whatever it is asked.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "base/temporary_folder.h"

namespace mjcourse {

class ScriptedPage {
 public:
  // In the place of Node a shell script that answers once.
  explicit ScriptedPage(const std::string& answer = "") {
    for (const char* name :
         {"version", "run.mjs", "header.pch", "engine/engine.mjs", "engine/engine.wasm"}) {
      write_file(folder() / name, "1\n");
    }
    answers(answer);
    runs("cat \"$2/answer\"; exec cat >/dev/null");
  }

  const std::filesystem::path& folder() const { return folder_.path(); }

  void answers(const std::string& answer) const {
    const std::uint64_t size = answer.size();
    std::string framed(sizeof size, '\0');
    std::memcpy(framed.data(), &size, sizeof size);
    write_file(folder() / "answer", framed + answer);
  }

  // `program` is what the shell does that is to answer.
  void runs(const std::string& program) const {
    const std::filesystem::path node = folder() / "node";
    write_file(node, "#!/bin/sh\n" + program + "\n");
    std::filesystem::permissions(node, std::filesystem::perms(0755));
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace mjcourse
