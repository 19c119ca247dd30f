#include "allocation_scope.h"

#include <mujoco/mujoco.h>

#include <cstdlib>

namespace {

// MuJoCo's own alignment.
constexpr std::size_t kAlignment = 64;

AllocationScope* current = nullptr;

}  // namespace

AllocationScope::AllocationScope() {
  current = this;
  mju_user_malloc = allocate;
  mju_user_free = release;
}

AllocationScope::~AllocationScope() {
  mju_user_malloc = nullptr;
  mju_user_free = nullptr;
  current = nullptr;
  for (void* block : blocks_) mju_free(block);
}

// NULL is what MuJoCo makes an error of.
void* AllocationScope::allocate(std::size_t size) {
  const std::size_t padded = (size + kAlignment - 1) / kAlignment * kAlignment;
  void* block = padded < size ? nullptr : std::aligned_alloc(kAlignment, padded);
  if (block != nullptr) current->blocks_.insert(block);
  return block;
}

void AllocationScope::release(void* block) {
  current->blocks_.erase(block);
  std::free(block);
}
