#pragma once

template <class T>
int twice(T x) {
  return x * 2;
}

inline int turns(int x) {
  return x / radius;
}
