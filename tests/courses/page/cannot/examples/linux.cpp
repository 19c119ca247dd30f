#include <sys/epoll.h>

int main() {
  return EPOLLIN - 1;
}
