/* Like glibc's a stable merge sort, so that MuJoCo puts equal contacts in the same order in the
 * page as natively. */
#include "qsort_r.h"

#include <stdlib.h>
#include <string.h>

typedef int (*Compare)(const void* a, const void* b, void* context);

/* Sort `count` elements at `base`; `spare` has room for them. */
static void sort(char* base, size_t count, size_t size, Compare compare, void* context,
                 char* spare) {
  if (count < 2) return;
  const size_t half = count / 2;
  char* left = base;
  char* right = base + half * size;
  char* const middle = right;
  char* const end = base + count * size;
  sort(left, half, size, compare, context, spare);
  sort(right, count - half, size, compare, context, spare);

  /* merge into the spare room; on a tie the left one comes first */
  char* next = spare;
  while (left < middle && right < end) {
    char** smaller = compare(left, right, context) <= 0 ? &left : &right;
    memcpy(next, *smaller, size);
    *smaller += size;
    next += size;
  }
  const size_t rest = (size_t)(middle - left);
  memcpy(next, left, rest);
  memcpy(base, spare, (size_t)(next - spare) + rest);
}

void qsort_r(void* base, size_t count, size_t size, Compare compare, void* context) {
  char* spare = malloc(count * size + 1);
  if (spare == NULL) abort();
  sort(base, count, size, compare, context, spare);
  free(spare);
}
