// The alphabetical order of a language, which is not that of its letters' codes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace mjcourse {

// The indices of `texts` in the order in which a dictionary of `language` ("en", "de-AT") has them,
// whatever their case. `bundle` is the text of script/collate.js.
std::vector<std::size_t> alphabetical(const std::string& bundle, const std::string& language,
                                      const std::vector<std::string>& texts);

}  // namespace mjcourse
