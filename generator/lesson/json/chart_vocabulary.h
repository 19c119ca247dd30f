// ```plot: what of it is ours. All other keys are Vega-Lite's, and the build holds them against its
// schema when it draws.
#pragma once

#include <array>

#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr std::array kChartDataKeys{
    Key{"name", KeyKind::text, "A program that a lesson shows, and its table: `EXAMPLE/TABLE`.",
        Need::filled}};
inline constexpr Vocabulary kChartData{"plot's data", kChartDataKeys};

inline constexpr std::array kChartKeys{
    Key{"data", KeyKind::object, "What is plotted.", Need::there, {}, &kChartData},
    Key{"caption", KeyKind::markdown, "Stands below the plot.", Need::filled},
    Key{"alt", KeyKind::text, "What it shows, in words, for those who cannot see it.",
        Need::filled}};
inline constexpr Vocabulary kChart{"plot", kChartKeys, {}, true};

}  // namespace mjcourse::words
