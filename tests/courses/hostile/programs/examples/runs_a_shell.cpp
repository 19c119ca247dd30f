#include <unistd.h>

int main() {
  execl("/bin/sh", "sh", "-c", "cat /etc/passwd", nullptr);
}
