// Spool: pieces of text that wait on the disk until they are all there.
//
// For files that are made of a piece from each of many lessons, which come in any order and would
// not have to fit into memory. The file goes with the spool, also when the process is killed.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace mjcourse {

class Spool {
 public:
  // Throws std::system_error where the folder for temporary files cannot be written.
  Spool();
  ~Spool();
  Spool(const Spool&) = delete;
  Spool& operator=(const Spool&) = delete;

  struct Piece {
    std::int64_t begin = 0;
    std::size_t size = 0;
  };
  // Both may be called on several threads at once. They throw std::system_error where the disk
  // fails.
  Piece put(std::string_view text);
  std::string get(Piece piece) const;

 private:
  int file_;
  std::atomic<std::int64_t> end_ = 0;
};

}  // namespace mjcourse
