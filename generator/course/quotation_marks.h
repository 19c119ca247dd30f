// The quotation marks of the world's languages.
#pragma once

#include <string>

#include "lesson/syntax/typography.h"

namespace mjcourse {

// Of the language whose tag of BCP 47 is `tag`; of English where its own are not known.
QuotationMarks quotation_marks(const std::string& tag);

}  // namespace mjcourse
