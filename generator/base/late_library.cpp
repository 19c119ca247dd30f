#include "base/late_library.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace mjcourse {

void* late_function(const char* library, const char* name) {
  // Global: MuJoCo looks for OpenGL among what is loaded.
  void* const loaded = dlopen(library, RTLD_LAZY | RTLD_GLOBAL);
  void* const found = loaded == nullptr ? nullptr : dlsym(loaded, name);
  if (found == nullptr)
    throw std::runtime_error(std::string("cannot load a library: ") + dlerror());
  return found;
}

}  // namespace mjcourse
