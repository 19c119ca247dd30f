// What `accept` does to a file, for the author, who is to agree.
// Tested by tests/accept.
#pragma once

#include <string>

#include "report/file_edits.h"

namespace mjcourse {

// "content/1-state/1.2-….md: the output of l1_2_second_box", and the diff. Of what is no text:
// "writes FILE (1.2 KB)".
std::string edit_text(const FileEdit& edit, bool colours);

}  // namespace mjcourse
