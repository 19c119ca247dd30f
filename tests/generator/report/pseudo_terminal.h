// A terminal so many columns wide, which nobody looks at.
//
// There is none where devpts is not mounted, as in a bare chroot: a test that needs one skips then.
#pragma once

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>

namespace mjcourse {

class PseudoTerminal {
 public:
  explicit PseudoTerminal(unsigned short columns) : main_(posix_openpt(O_RDWR | O_NOCTTY)) {
    if (main_ < 0) return;
    grantpt(main_);
    unlockpt(main_);
    descriptor_ = open(ptsname(main_), O_RDWR | O_NOCTTY);
    const winsize size{24, columns, 0, 0};
    ioctl(descriptor_, TIOCSWINSZ, &size);
  }
  ~PseudoTerminal() {
    close(descriptor_);
    close(main_);
  }
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  static bool exists() { return PseudoTerminal(80).descriptor() >= 0; }

  int descriptor() const { return descriptor_; }

 private:
  int main_, descriptor_ = -1;
};

}  // namespace mjcourse
