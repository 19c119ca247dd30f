// The checks of a program that is judged from outside (judge.h): each says what it found, and hears
// whether that holds.
//
// The judge puts this behind the includes of a program, with two macros in front of it:
// MJCOURSE_JUDGE, a name that the program cannot know, and MJCOURSE_MARK, the key of its marks.
// Macros (judged_text.cpp) then give each check a Call as its first argument, and leave out what
// the program is not to know. Stdin is a socket to the judge until the program begins; what it then
// reads there is at its end.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <mjcourse/mjcourse.hpp>
#include <type_traits>

namespace MJCOURSE_JUDGE {

struct Call {};

inline int take_stdin() {
  const int socket = dup(STDIN_FILENO);
  const int nothing = open("/dev/null", O_RDONLY);
  if (nothing < 0) {
    close(STDIN_FILENO);
  } else {
    dup2(nothing, STDIN_FILENO);
    close(nothing);
  }
  return socket;
}

static const int socket_to_judge = take_stdin();

inline void send(const char* bytes, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = write(socket_to_judge, bytes, size);
    if (sent < 0 && errno != EINTR) return;
    bytes += std::max<ssize_t>(sent, 0);
    size -= static_cast<std::size_t>(std::max<ssize_t>(sent, 0));
  }
}

// Each report has a mark in front: a hash of its number and its text under a key.
inline void say(const std::string& report) {
  static unsigned long number = 0;
  const std::string numbered = std::to_string(number++) + report;
  char mark[17];
  std::snprintf(mark, sizeof mark, "%016llx",
                static_cast<unsigned long long>(
                    mjcourse::sip_hash(MJCOURSE_MARK, numbered.data(), numbered.size())));
  send((mark + report).data(), sizeof mark - 1 + report.size());
}

// A program that comes to its end says so, and gives its exit code.
inline int ended(int code) {
  say("{\"ended\": true}\n");
  return code;
}

// Whether it holds.
inline bool ask(const std::string& report) {
  say(report);
  char answer = '0';
  while (read(socket_to_judge, &answer, 1) < 0 && errno == EINTR) {
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

// A value as the overload for what it is held against takes it, of which only the type is known.
template <typename Expected, typename Value>
  requires std::is_convertible_v<Expected, double>
double like(const Value& value) {
  return value;
}
template <typename Expected, typename Value>
  requires(!std::is_convertible_v<Expected, double>)
Eigen::VectorXd like(const Value& value) {
  return Eigen::Ref<const Eigen::VectorXd>(value);
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

inline bool expect(MJCOURSE_JUDGE::Call, bool holds, const std::string& what,
                   const std::string& meaning = "", double points = 1,
                   int line = __builtin_LINE()) {
  MJCOURSE_JUDGE::say(MJCOURSE_JUDGE::report(
      {what, meaning, points, line}, std::string("\"holds\": ") + (holds ? "true" : "false")));
  return holds;
}

// Of a program that knows what is expected.
template <typename Value, typename Expected>
bool expect_near(MJCOURSE_JUDGE::Call, const Value& value, const Expected& expected,
                 double tolerance, const std::string& what, const std::string& meaning = "",
                 double points = 1, int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(like<Expected>(value))) +
                        other_of("expected", numbers(like<Expected>(expected)), tolerance)));
}

// Of one that does not: the value comes from like().
template <typename Value>
bool expect_near(MJCOURSE_JUDGE::Call, const Value& value, const std::string& what,
                 const std::string& meaning = "", double points = 1, int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line}, value_of(numbers(value))));
}

template <typename Value, typename Other>
bool expect_alike(MJCOURSE_JUDGE::Call, const Value& value, const Other& other, double tolerance,
                  const std::string& what, const std::string& meaning = "", double points = 1,
                  int line = __builtin_LINE()) {
  using namespace MJCOURSE_JUDGE;
  return ask(report({what, meaning, points, line},
                    value_of(numbers(like<Other>(value))) +
                        other_of("other", numbers(like<Other>(other)), tolerance)));
}

}  // namespace mjcourse
