// A terminal so many columns wide.
//
// There is none where devpts is not mounted, as in a bare chroot: a test that needs one skips then.
#pragma once

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>

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

  // All that was written to it since this was asked last.
  std::string written() const {
    fcntl(main_, F_SETFL, O_NONBLOCK);
    std::string text;
    std::array<char, 4096> part;
    for (ssize_t count; (count = read(main_, part.data(), part.size())) > 0;) {
      text.append(part.data(), static_cast<std::size_t>(count));
    }
    return text;
  }

 private:
  int main_, descriptor_ = -1;
};

}  // namespace mjcourse
