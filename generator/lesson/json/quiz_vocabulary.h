// ```quiz: its objects, from the inside out.
#pragma once

#include <array>

#include "lesson/json/vocabulary.h"

namespace mjcourse::words {

inline constexpr Limits kJointCount{0, 1000, "counts joints: a whole number from 0 to 1000"};

inline constexpr std::array kJointsKeys{
    Key{"free", KeyKind::whole, "How many free joints.", Need::none, kJointCount},
    Key{"ball", KeyKind::whole, "How many ball joints.", Need::none, kJointCount},
    Key{"slide", KeyKind::whole, "How many slide joints.", Need::none, kJointCount},
    Key{"hinge", KeyKind::whole, "How many hinge joints.", Need::none, kJointCount}};
inline constexpr Vocabulary kJoints{"set of joints", kJointsKeys};

inline constexpr std::array kProofKeys{
    Key{"joints",
        KeyKind::object,
        "Build a model with just these joints: `{\"hinge\": 7}`.",
        Need::none,
        {},
        &kJoints},
    Key{"model", KeyKind::text, "Take a model of the course, by its name."},
    Key{"mjcf", KeyKind::mjcf, "Compile this text."},
    Key{"example", KeyKind::text, "Take what this program reported."},
    Key{"because", KeyKind::text, "Why the answer can only be asserted."},
    Key{"run", KeyKind::script, "What is done to the model, from a fresh state."},
    Key{"seconds",
        KeyKind::number,
        "Simulated time that passes then.",
        Need::none,
        {0, 100, "is simulated time: from 0 to 100"}},
    Key{"value", KeyKind::script,
        "The expression that must give the answer; with `example`, the name of a result."},
    Key{"equals", KeyKind::number, "What `value` must be instead of the answer."},
    Key{"options", KeyKind::expressions,
        "An expression for each option: exactly the right ones hold."},
    Key{"values", KeyKind::expressions,
        "An expression for each item of an order: they must grow."}};
inline constexpr Vocabulary kProof{"proof", kProofKeys};

inline constexpr std::array kOptionKeys{
    Key{"text", KeyKind::markdown, "The option.", Need::filled},
    Key{"feedback", KeyKind::markdown, "Said to a reader who chose it."}};
inline constexpr Vocabulary kOption{"option", kOptionKeys};

inline constexpr Key kKindKey{"kind", KeyKind::word, "What is asked for.", Need::filled};
inline constexpr Key kQuestionKey{"q", KeyKind::markdown, "The question.", Need::filled};
inline constexpr Key kHintKey{"hint", KeyKind::markdown, "Offered after a wrong answer."};
inline constexpr Key kExplainKey{"explain", KeyKind::markdown, "Shown with the answer."};
inline constexpr Key kVerifyKey{"verify",
                                KeyKind::objects,
                                "How the build finds the answer by itself; every proof must hold.",
                                Need::none,
                                {},
                                &kProof};
// Each is named by a letter.
inline constexpr Limits kOptionCount{2, 26, "lists from 2 to 26"};
inline constexpr Key kOptionsKey{"options",
                                 KeyKind::texts_or_objects,
                                 "From two to 26 to choose from.",
                                 Need::there,
                                 kOptionCount,
                                 &kOption};

inline constexpr std::array kNumericKeys{
    kKindKey,
    kQuestionKey,
    kHintKey,
    kExplainKey,
    Key{"tol", KeyKind::tolerance, "How far off an answer may be: a number, or as `\"1%\"`."},
    Key{"unit", KeyKind::text, "Shown after the field."},
    Key{"answer", KeyKind::number, "The right number.", Need::there},
    kVerifyKey};
inline constexpr Vocabulary kNumeric{"question", kNumericKeys};

inline constexpr std::array kSingleKeys{
    kKindKey,
    kQuestionKey,
    kHintKey,
    kExplainKey,
    kOptionsKey,
    Key{"answer",
        KeyKind::whole,
        "The index of the right option, counted from 0.",
        Need::there,
        {0, 25, "is the index of the right option, counted from 0"}},
    kVerifyKey};
inline constexpr Vocabulary kSingle{"question", kSingleKeys};

inline constexpr std::array kMultiKeys{
    kKindKey,
    kQuestionKey,
    kHintKey,
    kExplainKey,
    kOptionsKey,
    Key{"answer",
        KeyKind::indices,
        "The indices of the right options, counted from 0.",
        Need::there,
        {1, 26, "lists the indices of the right options, counted from 0"}},
    kVerifyKey};
inline constexpr Vocabulary kMulti{"question", kMultiKeys};

inline constexpr std::array kOrderKeys{
    kKindKey,
    kQuestionKey,
    kHintKey,
    kExplainKey,
    Key{"items", KeyKind::texts, "From two to 26, as they should stand; the page mixes them.",
        Need::there, kOptionCount},
    kVerifyKey};
inline constexpr Vocabulary kOrder{"question", kOrderKeys};

inline constexpr std::array kQuestionKeys{kKindKey};
inline constexpr std::array kQuestions{Variant{"numeric", &kNumeric}, Variant{"mcq", &kSingle},
                                       Variant{"multi", &kMulti}, Variant{"order", &kOrder}};
inline constexpr Vocabulary kQuestion{"question", kQuestionKeys, kQuestions};

inline constexpr std::array kQuizKeys{
    Key{"id", KeyKind::text, "What the reader's browser remembers the answers by.", Need::filled},
    Key{"title", KeyKind::text, "What the check is called."},
    Key{"questions", KeyKind::objects, "The questions.", Need::there, {}, &kQuestion}};
inline constexpr Vocabulary kQuiz{"quiz", kQuizKeys};

}  // namespace mjcourse::words
