// A film: pictures one after another, as a file for the page.
//
//   Film film(30);
//   film.add(picture);  // of an even size, and the first one's
//   film.encode();
//
// H.264 in MP4, which every browser plays, made by ffmpeg on one thread: the same pictures give the
// same bytes.
#pragma once

#include <fstream>
#include <string>
#include <tl/expected.hpp>

#include "base/temporary_folder.h"
#include "physics/picture.h"

namespace mjcourse {

class Film {
 public:
  // `rate` is in pictures a second.
  explicit Film(int rate);

  // Throws std::system_error when the disk takes no more.
  void add(const Picture& picture);

  struct Fault {
    std::string message, cure;
  };
  // The bytes of the file.
  tl::expected<std::string, Fault> encode();

 private:
  int rate_;
  int width_ = 0, height_ = 0;
  TemporaryFolder folder_;
  std::ofstream frames_;
};

}  // namespace mjcourse
