// Shared libraries that are loaded by the first call of one of their functions.
//
// The linker of a program that names them would load them, and all that they need, whenever it
// starts: the script engine and the software that draws are four fifths of a start, and most
// commands use neither. Their functions are objects of the names that their headers declare, in our
// namespace, where a call finds them first:
//
//   inline const LateFunction<kOffscreenGraphics, decltype(::OSMesaMakeCurrent)> OSMesaMakeCurrent(
//       "OSMesaMakeCurrent");
//
// A call that misses them does not link.
#pragma once

#include <array>
#include <atomic>

namespace mjcourse {

// All that are loaded so. Results depend on them as on those that are linked
// (process/loaded_libraries.h).
inline constexpr const char* kScriptEngine = "libjavascriptcoregtk-4.1.so.0";
inline constexpr const char* kOffscreenGraphics = "libOSMesa.so.8";
inline constexpr std::array kLateLibraries = {kScriptEngine, kOffscreenGraphics};

// Loads the library, unless it is there. Throws std::runtime_error where it is not to be had.
void* late_function(const char* library, const char* name);

template <const char* const& library, typename Function>
class LateFunction;

template <const char* const& library, typename Result, typename... Arguments>
class LateFunction<library, Result(Arguments...)> {
 public:
  explicit constexpr LateFunction(const char* name) : name_(name) {}

  Result operator()(Arguments... arguments) const {
    // Threads that look it up at once all find the same.
    Pointer found = found_.load(std::memory_order_acquire);
    if (found == nullptr) {
      found = reinterpret_cast<Pointer>(late_function(library, name_));
      found_.store(found, std::memory_order_release);
    }
    return found(arguments...);
  }

 private:
  using Pointer = Result (*)(Arguments...);
  const char* name_;
  mutable std::atomic<Pointer> found_ = nullptr;
};

}  // namespace mjcourse
