#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

int main() {
  const int out = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(80);
  inet_pton(AF_INET, "192.0.2.1", &address.sin_addr);
  return connect(out, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 ? 0 : 1;
}
