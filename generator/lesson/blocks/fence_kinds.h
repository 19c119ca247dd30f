// The kinds of fences, with the options that each may have behind its name.
//
// A reader hands its options to Fence::finish, which refuses all others; an editor offers the same.
// Enter at fence_kinds(), where all are; a reader takes its own from `fences`.
// Tested by tests/generator/lsp/fence_suggestions_test.cpp.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace mjcourse {

struct FenceOption {
  std::string_view name;
  std::string_view meaning;                       // Markdown, one line
  bool needed = false;                            // an editor writes it along with the kind
  bool has_value = true;                          // `name=value`, or the name alone
  std::span<const std::string_view> values = {};  // where it is one of a few, examples of it
};

struct FenceKind {
  std::string words;  // with which it begins: "cpp snippet"
  std::string_view meaning;
  std::span<const FenceOption> options = {};
};

std::span<const FenceKind> fence_kinds();

// The one that begins with just these words; null where there is none.
const FenceKind* find_fence_kind(std::string_view words);

namespace fences {

inline constexpr std::array<std::string_view, 2> kProgramEnds{"exit:1", "compile-error"};
inline constexpr std::array<std::string_view, 1> kModelEnds{"error"};

inline constexpr FenceOption kFile{
    "file", "The program: `examples/NAME.cpp`; one region of it: `examples/NAME.cpp#REGION`.",
    true};
inline constexpr FenceOption kTimeout{"timeout",
                                      "After how many seconds, at most 600, it is stopped."};
inline constexpr double kMostSeconds = 600;
inline constexpr FenceOption kNative{"native", "No page runs it.", false, false};
inline constexpr FenceOption kWhyNative{"because", "Why no page runs it, behind `native`."};

inline constexpr std::array kProgram{
    kFile,
    kTimeout,
    FenceOption{"expect", "How it ends, if not well: `exit:1`, or `compile-error`.", false, true,
                kProgramEnds},
    FenceOption{"args", "Its arguments, between quotes."},
    FenceOption{"optimize", "It is compiled with `-O2`.", false, false},
    kNative,
    kWhyNative};
// How a program is built and run is said where all of it is shown.
inline constexpr std::array kRegion{kFile};
inline constexpr std::array kExercise{
    FenceOption{"file",
                "The program and the region that the reader writes: `examples/NAME.cpp#REGION`.",
                true},
    FenceOption{"hidden", "A program with checks that no page shows: `examples/NAME.cpp`."},
    kTimeout,
    FenceOption{"args", "Its arguments, between quotes."},
    FenceOption{"optimize", "It is compiled with `-O2`.", false, false},
    kNative,
    kWhyNative};
inline constexpr std::array kSnippet{
    FenceOption{"model", "The model that `m` and `d` are of.", true}, kTimeout, kNative,
    kWhyNative};
inline constexpr std::array kCommands{
    FenceOption{"files",
                "What of the course they see, between quotes: files, and folders as a whole."},
    kTimeout};
inline constexpr std::array kExcerpt{
    FenceOption{"model", "The model whose lines these are.", true}};
inline constexpr std::array kInlineModel{
    FenceOption{"expect", "`error`: it does not compile.", false, true, kModelEnds}};
inline constexpr std::array kOutput{
    FenceOption{"output", "The program above that prints it, if not the one just above."},
    FenceOption{"tol", "How far its numbers may be off."}};
inline constexpr std::array kUnchecked{FenceOption{"because", "Why nobody runs it.", true}};

}  // namespace fences

}  // namespace mjcourse
