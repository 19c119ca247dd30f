// What an exception says that main did not catch, in the words of other C++ libraries. The page
// calls it with what was thrown, and gets it in short: "std::runtime_error: no such model".
#include <cxxabi.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <typeinfo>

extern "C" void* __cxa_begin_catch(void*) noexcept;

namespace {

std::string thrown_type() {
  const std::type_info* type = abi::__cxa_current_exception_type();
  if (type == nullptr) return "?";
  int status = 1;
  char* readable = abi::__cxa_demangle(type->name(), nullptr, nullptr, &status);
  std::string name = readable != nullptr ? readable : type->name();
  std::free(readable);
  return name;
}

}  // namespace

extern "C" __attribute__((export_name("mjc_uncaught"))) const char* mjc_uncaught(void* thrown) {
  static std::string text;
  std::fflush(stdout);
  __cxa_begin_catch(thrown);
  text = thrown_type();
  std::fprintf(stderr, "terminate called after throwing an instance of '%s'\n", text.c_str());
  try {
    throw;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "  what():  %s\n", error.what());
    text += std::string(": ") + error.what();
  } catch (...) {
  }
  return text.c_str();
}
