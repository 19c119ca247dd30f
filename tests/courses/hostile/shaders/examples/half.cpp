// What was lent to one run leads elsewhere when the next one is lent the same.
#include <GL/osmesa.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <mjcourse/mjcourse.hpp>
#include <string>

double half(double x) {
  // #region answer
  return x / 2;
  // #starter
  // return 0;  // of 1: 0.5
  // #wrong doubles: the half of 1
  // return 2 * x;
  // #endregion
}

int main() {
  const std::string kept =
      std::string(std::getenv("MESA_SHADER_CACHE_DIR")) + "/mesa_shader_cache/9f";
  std::rename(kept.c_str(), (kept + "-was-here").c_str());
  if (symlink("/var/tmp/mjcourse-victim", kept.c_str()) != 0) return 1;
  mjcourse::expect_near(half(1), 0.5, 1e-9, "the half of 1");
}
