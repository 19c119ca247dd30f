#include "remote/passed_descriptor.h"

#include <sys/socket.h>

#include <array>
#include <cstring>

namespace mjcourse {
namespace {

// Room for one descriptor beside the bytes.
struct Control {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

}  // namespace

ssize_t send_with(int socket, std::string_view bytes, const Descriptor& passed) {
  Control control;
  iovec part{const_cast<char*>(bytes.data()), bytes.size()};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (passed.is_open()) {
    const int number = passed.get();
    message.msg_control = control.bytes.data();
    message.msg_controllen = control.bytes.size();
    cmsghdr* const header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof number);
    std::memcpy(CMSG_DATA(header), &number, sizeof number);
  }
  return sendmsg(socket, &message, MSG_NOSIGNAL);
}

Received receive_with(int socket, char* bytes, std::size_t size) {
  Control control;
  iovec part{bytes, size};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes.data();
  message.msg_controllen = control.bytes.size();
  Received received{recvmsg(socket, &message, MSG_CMSG_CLOEXEC)};
  const cmsghdr* const header = received.count > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    int number = -1;
    std::memcpy(&number, CMSG_DATA(header), sizeof number);
    received.passed = Descriptor(number);
  }
  return received;
}

}  // namespace mjcourse
