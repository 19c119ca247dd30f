#include "report/moved_lines.h"

namespace mjcourse {
namespace {

constexpr std::size_t kMostLines = 1000;  // of a diff that is searched

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\r") == std::string::npos;
}

// Lines that moved together.
struct Move {
  int first, last;  // where they stood
  int before;       // the line before which they stand now
};

std::string note(const Move& move) {
  std::string text = "line";
  if (move.first < move.last) text += "s";
  text += " " + std::to_string(move.first);
  if (move.first < move.last) text += "-" + std::to_string(move.last);
  return text + (move.before > move.last ? " moved below line " + std::to_string(move.before - 1)
                                         : " moved above line " + std::to_string(move.before));
}

}  // namespace

MovedLines moved_lines(const std::vector<DiffLine>& lines, const SameLine& same) {
  MovedLines found{std::vector<char>(lines.size(), 0), {}};
  if (lines.size() > kMostLines) return found;
  std::vector<Move> moves;
  std::size_t last_come = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const DiffLine& gone = lines[i];
    if (gone.kind != DiffLine::Kind::gone || is_blank(gone.text)) continue;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      const DiffLine& come = lines[j];
      if (come.kind != DiffLine::Kind::come || found.moved[j] != 0) continue;
      if (!same(gone.text, come.text)) continue;
      found.moved[i] = found.moved[j] = 1;
      const bool together = !moves.empty() && moves.back().last + 1 == gone.line &&
                            moves.back().before == come.line && last_come + 1 == j;
      if (together) {
        moves.back().last = gone.line;
      } else {
        moves.push_back({gone.line, gone.line, come.line});
      }
      last_come = j;
      break;
    }
  }
  for (const Move& move : moves) found.notes.push_back(note(move));
  return found;
}

}  // namespace mjcourse
