// The module of a lab: what the page's script gets of it (site/browser/lab/lab-module.ts).
//
// Enter with write_lab_module(). The module's name has a hash of its content, so browsers may keep
// it for ever; its models are files of their own, which labs share.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "findings/result.h"
#include "lesson/blocks/lab.h"

namespace mjcourse {

class PageWriter;

// What stands on the site beside a lab's page, by path below the root.
struct LabFiles {
  std::string module;                                   // the path of the module among `written`
  std::map<std::string, std::string> written;           // bytes
  std::map<std::string, std::filesystem::path> copied;  // files on the disk
};

// `name` is that of the lab in the course: "1.2-1". `writer` makes HTML of its texts.
LabFiles write_lab_module(const Lab& lab, const LabResult& result, const std::string& name,
                          const PageWriter& writer);

}  // namespace mjcourse
