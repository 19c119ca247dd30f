#include "course/quotation_marks.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "course/language.h"

namespace mjcourse {
namespace {

struct Row {
  std::string_view languages;  // with a script or a region where that matters; in small letters
  QuotationMarks marks;
};

// Of the delimiters of Unicode's CLDR 42, all that are not as in English. CLDR has no blanks; those
// of French are the narrow no-break spaces of its typography.
constexpr std::array kRows{
    Row{"am fa fr-ch rm", {"«", "»", "‹", "›"}},
    Row{"ar ur", {"”", "“", "’", "‘"}},
    Row{"ast br ca el es eu it kk sq ti "
        "pt-ao pt-ch pt-cv pt-gq pt-gw pt-lu pt-mo pt-mz pt-pt pt-st pt-tl",
        {"«", "»", "“", "”"}},
    Row{"es-419 es-ar es-bo es-br es-bz es-cl es-co es-cr es-cu es-do es-ec es-gt es-hn es-mx "
        "es-ni es-pa es-pe es-pr es-py es-sv es-us es-uy es-ve yue-hans zh-hans",
        kEnglishMarks},
    Row{"be ky ru uk", {"«", "»", "„", "“"}},
    Row{"bg lt", {"„", "“", "„", "“"}},
    Row{"bs", {"„", "”", "‘", "’"}},
    Row{"cs de dsb et hr hsb is lb mk sk sl", {"„", "“", "‚", "‘"}},
    Row{"fi he sv", {"”", "”", "’", "’"}},
    Row{"fr", {"«\u202f", "\u202f»", "«\u202f", "\u202f»"}},
    Row{"fr-ca", {"«\u202f", "\u202f»", "”", "“"}},
    Row{"hu", {"„", "”", "»", "«"}},
    Row{"hy", {"«", "»", "«", "»"}},
    Row{"ja yue zh-hant zh-hk zh-mo zh-tw", {"「", "」", "『", "』"}},
    Row{"ka", {"„", "“", "«", "»"}},
    Row{"nb nn no", {"«", "»", "‘", "’"}},
    Row{"nl", {"‘", "’", "‘", "’"}},
    Row{"pl ro", {"„", "”", "«", "»"}},
    Row{"sr", {"„", "“", "‘", "‘"}},
    Row{"ug", {"»", "«", "›", "‹"}},
    Row{"uz", {"“", "”", "’", "‘"}},
};

const Row* row_of(const std::string& language) {
  const auto names = [&](const Row& row) {
    return (" " + std::string(row.languages) + " ").find(" " + language + " ") != std::string::npos;
  };
  const auto found = std::ranges::find_if(kRows, names);
  return found == kRows.end() ? nullptr : &*found;
}

}  // namespace

QuotationMarks quotation_marks(const std::string& tag) {
  const LanguageParts parts = parts_of_language(tag);
  const Row* row = nullptr;
  // A script says more than a region: zh-Hans-TW is no zh-TW.
  for (const std::string& part : {parts.script, parts.region}) {
    if (row == nullptr && !part.empty()) row = row_of(parts.language + "-" + part);
  }
  if (row == nullptr) row = row_of(parts.language);
  return row == nullptr ? kEnglishMarks : row->marks;
}

}  // namespace mjcourse
