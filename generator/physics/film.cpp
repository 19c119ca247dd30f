#include "physics/film.h"

#include <cerrno>
#include <system_error>

#include "base/files.h"
#include "process/open_to_all.h"
#include "process/subprocess.h"

namespace mjcourse {
namespace {

constexpr const char* kFrames = "frames.rgb";
constexpr const char* kFilm = "film.mp4";
constexpr const char* kColours =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+full_chroma_int+bitexact,"
    "format=yuv420p";
constexpr double kMostEncoding = 600;  // of wall clock; a thousand megabytes take some thirty

// Whatever would put the time, the version or the number of threads into the file is off. The
// colours are those of BT.709, and said to be.
std::vector<std::string> command_line(const std::string& size, int rate) {
  return {"ffmpeg", "-nostdin", "-v", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
          size, "-framerate", std::to_string(rate), "-i", kFrames, "-vf", kColours, "-c:v",
          "libx264",
          // Half the time of the usual preset, for files of the same size that look the same.
          "-preset", "veryfast", "-crf", "20", "-threads", "1", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "bt709", "-map_metadata", "-1", "-fflags",
          "+bitexact", "-flags:v", "+bitexact", "-movflags", "+faststart", kFilm};
}

}  // namespace

Film::Film(int rate) : rate_(rate) {
  frames_.exceptions(std::ios::failbit | std::ios::badbit);
  frames_.open(folder_.path() / kFrames, std::ios::binary);
}

void Film::add(const Picture& picture) {
  width_ = picture.width;
  height_ = picture.height;
  frames_.write(reinterpret_cast<const char*>(picture.rgb.data()),
                static_cast<std::streamsize>(picture.rgb.size()));
}

tl::expected<std::string, Film::Fault> Film::encode() {
  frames_.close();
  Command command;
  command.arguments = command_line(std::to_string(width_) + "x" + std::to_string(height_), rate_);
  command.folder = folder_.path().string();
  command.seconds = kMostEncoding;
  command.sandbox = Sandbox{{}, {command.folder}};
  command.sandbox->reads_all = !can_be_reached_by_all(command.folder);
  command.sandbox->file_bytes = command.sandbox->folder_bytes = 4ull << 30;
  const Outcome outcome = run(command);
  if (outcome.end == Outcome::End::not_started && outcome.code == ENOENT) {
    return tl::unexpected(Fault{"ffmpeg, which makes the film, is not installed",
                                "install it: `apt-get install ffmpeg`"});
  }
  if (outcome.end != Outcome::End::exited || outcome.code != 0) {
    const std::string said = outcome.err.substr(0, outcome.err.find('\n'));
    return tl::unexpected(
        Fault{"ffmpeg made no film of it" + (said.empty() ? "" : ": " + said), ""});
  }
  return DiskFiles(folder_.path()).read(kFilm).map_error([](const std::string& why) {
    return Fault{"ffmpeg left no film: " + why, ""};
  });
}

}  // namespace mjcourse
