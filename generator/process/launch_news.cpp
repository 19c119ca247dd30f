#include "process/launch_news.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace mjcourse {
namespace {

struct Message {
  pid_t id = -1;
  int failure = 0;
};

// Room for one descriptor beside the message.
struct Control {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

void tell(int socket, Message told, int listener) {
  Control control;
  iovec part{&told, sizeof told};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (listener >= 0) {
    message.msg_control = control.bytes.data();
    message.msg_controllen = control.bytes.size();
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(header), &listener, sizeof listener);
  }
  sendmsg(socket, &message, MSG_NOSIGNAL);
}

}  // namespace

void tell_id(int socket, pid_t id) {
  tell(socket, {.id = id}, -1);
}

void tell_listener(int socket, int listener) {
  tell(socket, {}, listener);
}

void tell_failure(int socket, int error) {
  tell(socket, {.failure = error}, -1);
}

LaunchNews read_launch_news(int socket) {
  Message told;
  Control control;
  iovec part{&told, sizeof told};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = control.bytes.data();
  message.msg_controllen = control.bytes.size();
  ssize_t count = 0;
  do {
    count = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  } while (count < 0 && errno == EINTR);
  LaunchNews news;
  news.begun = count <= 0;
  news.id = told.id;
  news.failure = told.failure;
  const cmsghdr* header = count > 0 ? CMSG_FIRSTHDR(&message) : nullptr;
  if (header != nullptr && header->cmsg_type == SCM_RIGHTS) {
    int listener = -1;
    std::memcpy(&listener, CMSG_DATA(header), sizeof listener);
    news.listener = Descriptor(listener);
  }
  return news;
}

}  // namespace mjcourse
