// Offsets: where each byte of a text stood in the file that it was taken from.
//
// Bytes that stood side by side are one run. So are those that all stand for one byte, as the bytes
// of a folded value do. Thus a text takes a few words of memory however long it is.
#pragma once

#include <cstddef>
#include <vector>

namespace mjcourse {

class Offsets {
 public:
  // Bytes that stood from `begin` to `end`, and the one behind them.
  static Offsets side_by_side(std::size_t begin, std::size_t end);

  // Of the next byte.
  void push_back(std::size_t offset);
  // Of `count` next bytes, which all stood at `offset`.
  void append_still(std::size_t count, std::size_t offset);
  // Those of `other` from `begin` to before `end`.
  void append(const Offsets& other, std::size_t begin, std::size_t end);

  std::size_t operator[](std::size_t index) const;
  std::size_t back() const { return (*this)[size_ - 1]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

 private:
  // From byte `begin` of the text to the next run: they stood at `offset` and behind it, or all of
  // them at `offset`.
  struct Run {
    std::size_t begin, offset;
    bool moves;
  };
  void append_run(std::size_t count, std::size_t offset, bool moves);

  std::vector<Run> runs_;
  std::size_t size_ = 0;
};

}  // namespace mjcourse
