/* GNU's qsort_r, which emscripten's C library lacks; included before every file of MuJoCo. */
#ifndef MJCOURSE_ENGINE_QSORT_R_H_
#define MJCOURSE_ENGINE_QSORT_R_H_

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

void qsort_r(void* base, size_t count, size_t size,
             int (*compare)(const void* a, const void* b, void* context), void* context);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_ENGINE_QSORT_R_H_ */
