// What MuJoCo allocated, when it throws in the middle.
//
// mj_makeData and its like allocate a struct, a buffer and a stack, and where memory ends at the
// third the first two are lost. In a build that is of no account; in a page, where readers edit
// large models, a few lost bytes in the middle of the memory leave no hole that is large enough for
// the next one. So what loads or draws a model does it in a scope:
//
//   AllocationScope scope;
//   … mj_makeData(model) …
//   scope.keep();
#pragma once

#include <cstddef>
#include <set>

class AllocationScope {
 public:
  AllocationScope();
  // Frees what mju_malloc gave since the beginning and nobody freed, unless it is kept.
  ~AllocationScope();
  AllocationScope(const AllocationScope&) = delete;
  AllocationScope& operator=(const AllocationScope&) = delete;

  void keep() { blocks_.clear(); }

 private:
  static void* allocate(std::size_t size);
  static void release(void* block);

  std::set<void*> blocks_;
};
