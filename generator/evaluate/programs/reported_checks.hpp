// The checks of a program that is judged from outside (judge.h): each says what it found, and hears
// whether that holds.
//
// The judge puts this behind the includes of a program, with two macros in front of it:
// MJCOURSE_JUDGE, a name that the program cannot know, and MJCOURSE_MARK, a number of 64 bits.
// Macros (judged_text.cpp) then give each check a Call as its first argument, and leave out what
// the program is not to know. Stdin is a socket to the judge.
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <mjcourse/mjcourse.hpp>

namespace MJCOURSE_JUDGE {

struct Call {};

// Each report has another in front of it (splitmix64), so what is left of one in memory makes no
// other. next_mark() in judge.cpp is the same.
inline std::uint64_t next_mark() {
  static std::uint64_t state = MJCOURSE_MARK;
  std::uint64_t mark = (state += 0x9e3779b97f4a7c15u);
  mark = (mark ^ (mark >> 30)) * 0xbf58476d1ce4e5b9u;
  mark = (mark ^ (mark >> 27)) * 0x94d049bb133111ebu;
  return mark ^ (mark >> 31);
}

inline void send(const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = write(STDIN_FILENO, bytes, size);
    if (sent < 0 && errno != EINTR) return;
    bytes += std::max<ssize_t>(sent, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(sent, 0));
  }
}

inline void say(const std::string& report) {
  char mark[17];
  std::snprintf(mark, sizeof mark, "%016llx", static_cast<unsigned long long>(next_mark()));
  send(mark, sizeof mark - 1);
  for (volatile char& digit : mark) digit = 0;
  send(report.data(), report.size());
}

// Whether it holds.
inline bool ask(const std::string& report) {
  say(report);
  char answer = '0';
  while (read(STDIN_FILENO, &answer, 1) < 0 && errno == EINTR) {
  }
  return answer == '1';
}

inline std::string numbers(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "\"%.17g\"", x);
  return text;
}

// A vector begins with a bracket.
inline std::string numbers(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  std::string all = "\"[";
  for (const double x : vector) {
    char text[32];
    std::snprintf(text, sizeof text, " %.17g", x);
    all += text;
  }
  return all + '"';
}

struct Words {
  const std::string& what;
  const std::string& meaning;
  double points;
  int line;
};

inline std::string report(const Words& words, const std::string& found) {
  using mjcourse::to_json;
  return "{\"what\": " + to_json(words.what) + ", \"meaning\": " + to_json(words.meaning) +
         ", \"points\": " + to_json(words.points) + ", \"line\": " + std::to_string(words.line) +
         ", " + found + "}\n";
}

inline std::string value_of(const std::string& value) {
  return "\"value\": " + value;
}

inline std::string other_of(const char* name, const std::string& other, double tolerance) {
  return ", \"" + std::string(name) + "\": " + other + ", \"tolerance\": " + numbers(tolerance);
}

}  // namespace MJCOURSE_JUDGE

namespace mjcourse {

using Vector = Eigen::Ref<const Eigen::VectorXd>;

inline bool expect(MJCOURSE_JUDGE::Call, bool holds, const std::string& what,
                   const std::string& meaning = "", double points = 1,
                   int line = __builtin_LINE()) {
  MJCOURSE_JUDGE::say(MJCOURSE_JUDGE::report(
      {what, meaning, points, line}, std::string("\"holds\": ") + (holds ? "true" : "false")));
  return holds;
}

// Of a program that knows what is expected.
inline bool expect_near(MJCOURSE_JUDGE::Call, double value, double expected, double tolerance,
                        const std::string& what, const std::string& meaning = "", double points = 1,
                        int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(value)) + other_of("expected", numbers(expected), tolerance)));
}
inline bool expect_near(MJCOURSE_JUDGE::Call, const Vector& value, const Vector& expected,
                        double tolerance, const std::string& what, const std::string& meaning = "",
                        double points = 1, int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(value)) + other_of("expected", numbers(expected), tolerance)));
}

// Of one that does not.
inline bool expect_near(MJCOURSE_JUDGE::Call, double value, const std::string& what,
                        const std::string& meaning = "", double points = 1,
                        int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line}, value_of(numbers(value))));
}
inline bool expect_near(MJCOURSE_JUDGE::Call, const Vector& value, const std::string& what,
                        const std::string& meaning = "", double points = 1,
                        int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line}, value_of(numbers(value))));
}

inline bool expect_alike(MJCOURSE_JUDGE::Call, double value, double other, double tolerance,
                         const std::string& what, const std::string& meaning = "",
                         double points = 1, int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(value)) + other_of("other", numbers(other), tolerance)));
}
inline bool expect_alike(MJCOURSE_JUDGE::Call, const Vector& value, const Vector& other,
                         double tolerance, const std::string& what, const std::string& meaning = "",
                         double points = 1, int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(value)) + other_of("other", numbers(other), tolerance)));
}

}  // namespace mjcourse
