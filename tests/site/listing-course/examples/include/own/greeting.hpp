#pragma once

inline const char* greeting() {
  return "a header of the course's own";
}
