/* A page runs a program in one thread, so a new one runs to its end where it is made. One that
 * waits for another would wait forever: the program ends instead, and says so. */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

_Noreturn void mjc_thread_waits(void);

/* Numbers, which a program may compare and print. */
static unsigned long running = 1, last = 1;

pthread_t pthread_self(void) { return (pthread_t)running; }

int pthread_create(pthread_t* restrict thread, const pthread_attr_t* restrict attributes,
                   void* (*run)(void*), void* restrict argument) {
  (void)attributes;
  const unsigned long before = running;
  running = ++last;
  *thread = (pthread_t)running;
  run(argument);
  running = before;
  return 0;
}

int pthread_join(pthread_t thread, void** result) {
  (void)thread;
  if (result != NULL) *result = NULL;
  return 0;
}

int pthread_detach(pthread_t thread) {
  (void)thread;
  return 0;
}

int pthread_cond_wait(pthread_cond_t* restrict condition, pthread_mutex_t* restrict mutex) {
  (void)condition;
  (void)mutex;
  mjc_thread_waits();
}

int pthread_cond_timedwait(pthread_cond_t* restrict condition, pthread_mutex_t* restrict mutex,
                           const struct timespec* restrict until) {
  (void)condition;
  (void)mutex;
  (void)until;
  mjc_thread_waits();
}
