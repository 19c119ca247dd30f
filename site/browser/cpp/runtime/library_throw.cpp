// The C++ library of clang's package was built without exceptions: where it would throw, as in
// std::stoi, it calls a function that says so and ends the program. This one takes its place, and
// throws. What the library has on the stack is left without its destructors.
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace {

template <typename Error>
void raise(const char* message) {
  throw Error(message);
}

constexpr struct {
  std::string_view name;
  void (*raise)(const char* message);
} kErrors[] = {
    {"domain_error", raise<std::domain_error>}, {"invalid_argument", raise<std::invalid_argument>},
    {"length_error", raise<std::length_error>}, {"logic_error", raise<std::logic_error>},
    {"out_of_range", raise<std::out_of_range>}, {"overflow_error", raise<std::overflow_error>},
    {"range_error", raise<std::range_error>},   {"underflow_error", raise<std::underflow_error>},
};

}  // namespace

// As std::__libcpp_verbose_abort, whose declaration says that it never throws.
extern "C" [[noreturn]] void mjc_library_throw(const char* format, ...) __asm__(
    "_ZNSt3__222__libcpp_verbose_abortEPKcz");

// `format` is "out_of_range was thrown in -fno-exceptions mode with message \"%s\"".
extern "C" void mjc_library_throw(const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const std::string_view said(format);
  for (const auto& error : kErrors) {
    if (said.substr(0, said.find(' ')) == error.name) error.raise(va_arg(arguments, const char*));
  }
  std::vfprintf(stderr, format, arguments);
  std::abort();
}
