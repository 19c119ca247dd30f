// ```plot: what of it is ours. All other keys are Vega-Lite's, and the build holds them against its
// schema when it draws.
#pragma once

#include <array>

#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr std::array kPlotDataKeys{
    Key{"name", KeyKind::text, "A program that a lesson shows, and its table: `EXAMPLE/TABLE`.",
        Need::filled}};
inline constexpr Vocabulary kPlotData{"plot's data", kPlotDataKeys};

inline constexpr std::array kPlotKeys{
    Key{"data", KeyKind::object, "What is plotted.", Need::there, {}, &kPlotData},
    Key{"caption", KeyKind::markdown, "Stands below the plot.", Need::filled},
    Key{"alt", KeyKind::text, "What it shows, in words, for those who cannot see it.",
        Need::filled}};
inline constexpr Vocabulary kPlot{"plot", kPlotKeys, {}, true};

}  // namespace mjcourse::words
