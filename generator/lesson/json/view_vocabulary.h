// What labs and figures say of how they are seen.
#pragma once

#include <array>

#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr std::array kCameraKeys{
    Key{"azimuth", KeyKind::number, "From which side, in degrees; 90 by default."},
    Key{"elevation", KeyKind::number,
        "From how high, in degrees; negative looks down; -45 by default."},
    Key{"distance", KeyKind::number, "From how far, in metres; 2 by default."},
    Key{"target", KeyKind::point,
        "The point that is looked at, in metres; the origin by default."}};
inline constexpr Vocabulary kCamera{"camera", kCameraKeys};

inline constexpr Key kCameraKey{"camera",
                                KeyKind::object,
                                "Where it is seen from; without one, the whole model is in view.",
                                Need::none,
                                {},
                                &kCamera};
inline constexpr Key kOverlaysKey{
    "overlays", KeyKind::overlays,
    "What MuJoCo draws besides, from the start: `{\"joints\": true}`."};
inline constexpr Key kPinKey{"pin", KeyKind::text,
                             "A name for its picture, which is then held against a reference: "
                             "small letters, digits, hyphens."};

}  // namespace mjcourse::words
