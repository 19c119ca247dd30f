// ```figure
#pragma once

#include <array>

#include "lesson/json/view_vocabulary.h"
#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr std::array kAnimationKeys{
    Key{"seconds",
        KeyKind::number,
        "How long the film is, as long in the simulation as in the page.",
        Need::there,
        {0.1, 60, "is how long an animation takes: from 0.1 to 60 seconds"}},
    Key{"fps",
        KeyKind::whole,
        "Frames a second; 30 by default.",
        Need::none,
        {1, 60, "is a whole number of frames: from 1 to 60 a second"}}};
inline constexpr Vocabulary kAnimation{"animation", kAnimationKeys};

inline constexpr std::array kFigureKeys{
    Key{"model", KeyKind::model, "A model's name, or MJCF itself, which begins with `<`.",
        Need::filled},
    kCameraKey,
    kOverlaysKey,
    Key{"keyframe", KeyKind::text, "The keyframe that it starts from, by its name."},
    Key{"run", KeyKind::script, "What is done to it then."},
    Key{"seconds",
        KeyKind::number,
        "Simulated time that passes then, before the picture.",
        Need::none,
        {0, 100, "is simulated time before the picture: from 0 to 100 seconds"}},
    Key{"from", KeyKind::text, "A state that a program recorded: `EXAMPLE/SNAPSHOT`."},
    Key{"size",
        KeyKind::size,
        "Width and height in pixels; `[640, 400]` by default.",
        Need::none,
        {16, 1024, "is a width and a height in pixels: two whole numbers from 16 to 1024"}},
    Key{"animate", KeyKind::object, "A film of what comes next.", Need::none, {}, &kAnimation},
    Key{"caption", KeyKind::markdown, "Stands below it."},
    Key{"alt", KeyKind::text, "What it shows, in a sentence, for those who cannot see it.",
        Need::filled},
    kPinKey};
inline constexpr Vocabulary kFigure{"figure", kFigureKeys};

}  // namespace mjcourse::words
