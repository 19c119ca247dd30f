// ```lab simlab: its objects, from the inside out.
#pragma once

#include <array>

#include "lesson/json/view_vocabulary.h"
#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr Limits kDigits{0, 15,
                                "counts the digits after the point: a whole number from 0 to 15"};
inline constexpr Limits kTolerance{0, std::numeric_limits<double>::max(),
                                   "is how far off a number may be: 0 or more"};

inline constexpr Key kTypeKey{"type", KeyKind::word, "What kind of control it is.", Need::filled};
inline constexpr Key kLabelKey{"label", KeyKind::text, "What is written on it.", Need::filled};
inline constexpr Key kUnitKey{"unit", KeyKind::text, "Shown after the number."};
inline constexpr Key kValueKey{"value", KeyKind::expression,
                               "The expression that gives the number.", Need::filled};

inline constexpr std::array kButtonKeys{
    kTypeKey, kLabelKey,
    Key{"run", KeyKind::script, "What it does, once for each press.", Need::there}};
inline constexpr Vocabulary kButton{"button", kButtonKeys};

inline constexpr std::array kSliderKeys{
    kTypeKey,
    kLabelKey,
    Key{"bind", KeyKind::expression,
        "What it sets: something that can be assigned to, `ctrl('motor')[0]`.", Need::filled},
    Key{"min", KeyKind::number, "Its lower end.", Need::there},
    Key{"max", KeyKind::number, "Its upper end.", Need::there},
    Key{"step",
        KeyKind::number,
        "How far it goes at a time; a two-hundredth of the way by default.",
        Need::none,
        {kAboveZero, std::numeric_limits<double>::max(),
         "is how far the slider goes at a time: more than 0"}},
    Key{"value", KeyKind::number,
        "Where it starts, at every reset; without one, what the model has."},
    Key{"digits", KeyKind::whole, "Digits after the point; 2 by default.", Need::none, kDigits},
    kUnitKey};
inline constexpr Vocabulary kSlider{"slider", kSliderKeys};

inline constexpr std::array kToggleKeys{
    kTypeKey, kLabelKey,
    Key{"on", KeyKind::script, "What happens when it is switched on.", Need::filled},
    Key{"off", KeyKind::script, "What happens when it is switched off.", Need::filled},
    Key{"value", KeyKind::boolean, "`true` when it starts on; `on` then runs at every reset."}};
inline constexpr Vocabulary kToggle{"toggle", kToggleKeys};

inline constexpr std::array kChoiceKeys{
    kLabelKey, Key{"run", KeyKind::script, "What happens when it is chosen.", Need::there}};
inline constexpr Vocabulary kChoice{"option", kChoiceKeys};

inline constexpr std::array kSelectKeys{
    kTypeKey, kLabelKey,
    Key{"options", KeyKind::objects, "What there is to choose from.", Need::filled, {}, &kChoice},
    Key{"value",
        KeyKind::whole,
        "The index of the option that runs at every reset, counted from 0.",
        Need::none,
        {0, std::numeric_limits<double>::max(), "is the index of an option, counted from 0"}}};
inline constexpr Vocabulary kSelect{"select", kSelectKeys};

inline constexpr std::array kKeyframeKeys{
    kTypeKey, kLabelKey,
    Key{"key", KeyKind::text, "A keyframe of the model, by its name.", Need::filled}};
inline constexpr Vocabulary kKeyframe{"keyframe", kKeyframeKeys};

inline constexpr std::array kControlKeys{kTypeKey};
inline constexpr std::array kControls{Variant{"button", &kButton}, Variant{"slider", &kSlider},
                                      Variant{"toggle", &kToggle}, Variant{"select", &kSelect},
                                      Variant{"keyframe", &kKeyframe}};
inline constexpr Vocabulary kControl{"control", kControlKeys, kControls};

inline constexpr Key kExpressionKey{"expr", KeyKind::expression, "What is read.", Need::filled};
inline constexpr std::array kReadoutKeys{
    kLabelKey, kExpressionKey,
    Key{"digits", KeyKind::whole, "Digits after the point; 3 by default.", Need::none, kDigits},
    kUnitKey};
inline constexpr Vocabulary kReadout{"readout", kReadoutKeys};

inline constexpr std::array kTraceKeys{kLabelKey, kExpressionKey};
inline constexpr Vocabulary kTrace{"trace", kTraceKeys};

inline constexpr std::array kLabPlotKeys{
    Key{"ylabel", KeyKind::text, "What is written beside the plot: quantities and units."},
    Key{"window",
        KeyKind::number,
        "Seconds that it shows; 5 by default.",
        Need::none,
        {0.1, 1000, "is a number of seconds: from 0.1 to 1000"}},
    Key{"ymin", KeyKind::number, "Its lower end; without one, it finds its own."},
    Key{"ymax", KeyKind::number, "Its upper end; without one, it finds its own."},
    Key{"traces",
        KeyKind::objects,
        "What it shows, up to four.",
        Need::filled,
        {1, 4, "has colours for four"},
        &kTrace}};
inline constexpr Vocabulary kLabPlot{"plot", kLabPlotKeys};

inline constexpr std::array kPredictionKeys{
    Key{"q", KeyKind::markdown, "What the reader is to guess.", Need::filled},
    Key{"run", KeyKind::script, "What is done after the reset and before the seconds."},
    kValueKey,
    Key{"seconds",
        KeyKind::number,
        "Simulated time until the value is read.",
        Need::there,
        {kAboveZero, 100, "is simulated time: more than 0, at most 100"}},
    Key{"tol", KeyKind::number, "How near is near enough; 0 by default.", Need::none, kTolerance},
    Key{"digits", KeyKind::whole, "Digits after the point; 3 by default.", Need::none, kDigits},
    kUnitKey,
    Key{"explain", KeyKind::markdown, "Said afterwards."}};
inline constexpr Vocabulary kPrediction{"prediction", kPredictionKeys};

inline constexpr std::array kSolutionKeys{
    Key{"run", KeyKind::script, "A script that reaches the goal."},
    Key{"model", KeyKind::text, "A model of the course that does, where the reader edits one."},
    Key{"insert", KeyKind::mjcf, "MJCF to put into the lab's model, where the reader edits it."},
    Key{"before", KeyKind::text, "The text of the model that `insert` goes before."},
    Key{"seconds",
        KeyKind::number,
        "Simulated time within which the goal is reached.",
        Need::none,
        {0, 100, "is simulated time: from 0 to 100"}}};
inline constexpr Vocabulary kSolution{"solution", kSolutionKeys};

inline constexpr std::array kGoalKeys{
    Key{"text", KeyKind::markdown, "What the reader is to do.", Need::filled},
    Key{"done", KeyKind::expression, "Turns true when it is done.", Need::filled},
    Key{"solution",
        KeyKind::object,
        "How it can be done; the build tries it.",
        Need::there,
        {},
        &kSolution}};
inline constexpr Vocabulary kGoal{"goal", kGoalKeys};

inline constexpr std::array kGhostKeys{
    Key{"label", KeyKind::text, "What is different about it.", Need::filled},
    Key{"run", KeyKind::script, "What makes the difference, after each reset.", Need::filled}};
inline constexpr Vocabulary kGhost{"ghost", kGhostKeys};

inline constexpr std::array kTaskKeys{
    Key{"q", KeyKind::markdown, "Which number of the edited model the reader is to find.",
        Need::filled},
    kValueKey,
    Key{"tol", KeyKind::number, "How near is near enough; 0 by default.", Need::none, kTolerance},
    kUnitKey};
inline constexpr Vocabulary kTask{"task", kTaskKeys};

inline constexpr std::array kEditableKeys{Key{
    "tasks", KeyKind::objects, "Numbers to find for the edited model.", Need::filled, {}, &kTask}};
inline constexpr Vocabulary kEditable{"editable lab", kEditableKeys};

inline constexpr std::array kLabKeys{
    Key{"title", KeyKind::text, "What the lab is called.", Need::filled},
    Key{"model", KeyKind::model, "A model's name, or MJCF itself, which begins with `<`.",
        Need::filled},
    Key{"dock", KeyKind::boolean, "`true` keeps the lab beside the text on a wide screen."},
    Key{"height",
        KeyKind::number,
        "Of the picture, in pixels; 300 by default.",
        Need::none,
        {1, 1024, "is a number of pixels: from 1 to 1024"}},
    kCameraKey,
    Key{"toggles", KeyKind::texts, "Overlays that the reader can switch."},
    kOverlaysKey,
    Key{"define", KeyKind::script, "Functions and constants that the lab's scripts may use."},
    Key{"controls", KeyKind::objects, "What the reader can do.", Need::none, {}, &kControl},
    Key{"readouts",
        KeyKind::objects,
        "Numbers that are read all the way.",
        Need::none,
        {},
        &kReadout},
    Key{"plots", KeyKind::objects, "Plots over time.", Need::none, {}, &kLabPlot},
    Key{"speed",
        KeyKind::number,
        "Simulated seconds in a second; 1 by default.",
        Need::none,
        {0.1, 4, "is simulated seconds in a second: from 0.1 to 4"}},
    Key{"predict",
        KeyKind::object,
        "A number that the reader guesses first.",
        Need::none,
        {},
        &kPrediction},
    Key{"editable",
        KeyKind::true_or_object,
        "Whether the reader edits the model, and what for.",
        Need::none,
        {},
        &kEditable},
    Key{"goal", KeyKind::object, "What the reader is to reach.", Need::none, {}, &kGoal},
    Key{"ghost", KeyKind::object, "A second run beside the first.", Need::none, {}, &kGhost},
    Key{"alt", KeyKind::text,
        "What it shows before it is played, in a sentence, for those who cannot see it.",
        Need::filled},
    kPinKey,
    Key{"note", KeyKind::markdown, "Stands below the lab."}};
inline constexpr Vocabulary kLab{"lab", kLabKeys};

}  // namespace mjcourse::words
