/* The program's memory is the engine's: what one allocates, the other may free. */
#include <errno.h>
#include <stddef.h>

void* mjc_malloc(size_t size);
void mjc_free(void* memory);
void* mjc_calloc(size_t count, size_t size);
void* mjc_realloc(void* memory, size_t size);
void* mjc_memalign(size_t alignment, size_t size);

/* Tells the page, which says so where the program ends. */
void mjc_no_memory(void);

static void* or_tell(void* memory, size_t size) {
  if (memory == NULL && size > 0) mjc_no_memory();
  return memory;
}

void* malloc(size_t size) {
  return or_tell(mjc_malloc(size), size);
}
void free(void* memory) {
  mjc_free(memory);
}
void* calloc(size_t count, size_t size) {
  return or_tell(mjc_calloc(count, size), count * size);
}
void* realloc(void* memory, size_t size) {
  return or_tell(mjc_realloc(memory, size), size);
}
void* memalign(size_t alignment, size_t size) {
  return or_tell(mjc_memalign(alignment, size), size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  return memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) {
  *memory = memalign(alignment, size);
  return *memory == NULL ? ENOMEM : 0;
}

/* What the C library calls them inside. */
void* __libc_malloc(size_t size) {
  return malloc(size);
}
void* __libc_calloc(size_t count, size_t size) {
  return calloc(count, size);
}
void __libc_free(void* memory) {
  free(memory);
}
