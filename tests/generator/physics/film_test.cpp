#include "physics/film.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mjcourse {
namespace {

Picture plain(std::uint8_t shade) {
  return {32, 16, std::vector<std::uint8_t>(std::size_t{3} * 32 * 16, shade)};
}

tl::expected<std::string, Film::Fault> film_of(const std::vector<Picture>& pictures) {
  Film film(10);
  for (const Picture& picture : pictures) film.add(picture);
  return film.encode();
}

TEST(Film, IsAnMp4ThatBeginsToPlayBeforeItIsThere) {
  const auto film = film_of({plain(0), plain(100), plain(200)});
  ASSERT_TRUE(film) << film.error().message;
  EXPECT_EQ(film->substr(4, 4), "ftyp");
  EXPECT_LT(film->find("moov"), film->find("mdat"));
  EXPECT_NE(film->find("avc1"), std::string::npos);
}

TEST(Film, HasTheSameBytesEachTime) {
  const std::string film = film_of({plain(0), plain(100), plain(200)}).value();
  EXPECT_EQ(film, film_of({plain(0), plain(100), plain(200)}).value());
  EXPECT_NE(film, film_of({plain(0), plain(100), plain(210)}).value());
}

TEST(Film, SaysWhatFfmpegSays) {
  const auto film = film_of({{31, 16, std::vector<std::uint8_t>(std::size_t{3} * 31 * 16)}});
  ASSERT_FALSE(film);
  EXPECT_TRUE(film.error().message.starts_with("ffmpeg made no film of it: "))
      << film.error().message;
}

TEST(Film, NeedsFfmpeg) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const auto film = film_of({plain(0), plain(100)});
  setenv("PATH", path.c_str(), 1);
  ASSERT_FALSE(film);
  EXPECT_EQ(film.error().message, "ffmpeg, which makes the film, is not installed");
  EXPECT_EQ(film.error().cure, "install it: `apt-get install ffmpeg`");
}

}  // namespace
}  // namespace mjcourse
