/* What a reader's run printed beside what the lesson states, compared as the build compares. */
#ifndef MJCOURSE_OUTPUT_CHANGES_H_
#define MJCOURSE_OUTPUT_CHANGES_H_

#include <emscripten/emscripten.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How many lines of `stated` are gone from `real`, and behind it the numbers of those that come
 * there, from 1, all with a blank between: "0" where the texts agree
 * (generator/evaluate/programs/output_diff.h). `tolerance` is absolute; below 0, it is the unit of
 * the last place that is stated. The text lasts until the next call. */
EMSCRIPTEN_KEEPALIVE const char* mjc_output_changes(const char* stated, int stated_size,
                                                    const char* real, int real_size,
                                                    double tolerance);

#ifdef __cplusplus
}
#endif

#endif /* MJCOURSE_OUTPUT_CHANGES_H_ */
