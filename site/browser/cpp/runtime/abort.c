/* The page says that the program called it. */
#include <stdlib.h>

_Noreturn void mjc_abort(void);

_Noreturn void abort(void) {
  mjc_abort();
}
