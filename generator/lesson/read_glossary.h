// From the bytes of content/glossary.md to a Glossary.
#pragma once

#include <optional>
#include <string>

#include "lesson/glossary.h"
#include "report/diagnostic.h"

namespace mjcourse {

// Mistakes go to `diagnostics`; nothing is returned only when the file cannot be read at all.
std::optional<Glossary> read_glossary(std::string bytes, Diagnostics& diagnostics,
                                      const Typography& typography = {});

}  // namespace mjcourse
