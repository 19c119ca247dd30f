#include "remote/http_client.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>

#include "base/files.h"
#include "base/temporary_folder.h"
#include "process/sandbox.h"

namespace mjcourse {
namespace {

// Somebody who takes connections at a port of this machine.
class Listener {
 public:
  Listener() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    place_.sin_family = AF_INET;
    place_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof place_;
    auto* const any = reinterpret_cast<sockaddr*>(&place_);
    if (bind(socket_.get(), any, size) != 0 || listen(socket_.get(), 8) != 0 ||
        getsockname(socket_.get(), any, &size) != 0) {
      throw_errno("a socket");
    }
  }
  std::string port() const { return std::to_string(ntohs(place_.sin_port)); }

 private:
  Descriptor socket_;
  sockaddr_in place_{};
};

// A program in place of mjcourse-net that was taken over (hostile_net.cpp).
class HttpClientTest : public testing::Test {
 protected:
  static std::string done(const Server& server, const std::string& deeds) {
    return HttpClient(MJCOURSE_HOSTILE_NET, server).ask("GET", "ac/0", deeds).content;
  }

  static Server at(const std::string& url) {
    Server server;
    server.address = read_store_address(url).value();
    server.token = "a token";
    return server;
  }

  // Each deed with what came of it.
  static std::string with(const std::vector<std::string>& deeds, const std::string& answer) {
    std::string text;
    for (const std::string& deed : deeds) text += deed + answer + "\n";
    return text;
  }

  std::string secret(const std::string& name) const {
    const std::string path = (folder_.path() / name).string();
    write_file(path, "a secret");
    return path;
  }

  TemporaryFolder folder_;
};

TEST_F(HttpClientTest, LetsItsProgramReachNothingThatItNeedsNot) {
  const Listener other;
  setenv("MJCOURSE_STORE_TOKEN", "a token", 1);
  const std::string parent = std::to_string(getpid());
  const std::vector<std::string> forbidden{"reads " + secret("key"),
                                           "reads /etc/passwd",
                                           "reads /etc/shadow",
                                           "reads " MJCOURSE_ROOT "/README.md",
                                           "reads /proc/" + parent + "/environ",
                                           "lists " MJCOURSE_ROOT,
                                           "lists /etc/ssl/private",
                                           "lists /home",
                                           "lists /tmp",
                                           "lists /run",
                                           "writes " + (folder_.path() / "x").string(),
                                           "writes /tmp/mjcourse-hostile",
                                           "writes /dev/shm/mjcourse-hostile",
                                           "knows MJCOURSE_STORE_TOKEN",
                                           "knows MJCOURSE_ROOT",
                                           "knows USER",
                                           "starts /bin/true",
                                           "starts " MJCOURSE_HOSTILE_NET,
                                           "signals " + parent,
                                           "traces " + parent,
                                           "serves 0",
                                           "serves 18080",
                                           "sends-at-once " + other.port(),
                                           "socket 1 1",      // of this machine
                                           "socket 16 3",     // of the kernel
                                           "socket 17 3",     // of all that goes by
                                           "socket 2 3 1",    // ICMP
                                           "socket 2 1 132",  // SCTP
                                           "socket 2 1 262",  // TCP by many ways
                                           "socket 40 1",     // of a virtual machine
                                           "takes 5"};
  EXPECT_EQ(done(at("http://127.0.0.1:1"), with(forbidden, "")), with(forbidden, ": no"));
  unsetenv("MJCOURSE_STORE_TOKEN");
}

TEST_F(HttpClientTest, LetsItsProgramConnectToTheServersPortAlone) {
  const Listener server, proxy, other;
  setenv("http_proxy", ("http://ann:secret@127.0.0.1:" + proxy.port()).c_str(), 1);
  const bool knows_tcp = sandbox_level().landlock >= 4;
  const std::vector<std::string> all{"connects " + server.port(),
                                     "connects " + proxy.port(),
                                     "connects " + other.port(),
                                     "knows http_proxy",
                                     "reads /etc/hosts",
                                     "reads /usr/bin/env",
                                     "socket 2 2",
                                     "is-root"};
  const std::string said = done(at("http://127.0.0.1:" + server.port()), with(all, ""));
  EXPECT_EQ(said, all[0] + ": yes\n" + all[1] + ": yes\n" + all[2] +
                      (knows_tcp ? ": no\n" : ": yes\n") + all[3] + ": yes\n" + all[4] + ": yes\n" +
                      all[5] + ": yes\n" + all[6] + ": yes\n" + all[7] + ": no\n");
  unsetenv("http_proxy");
}

TEST_F(HttpClientTest, GivesItsProgramNoSocketsBesideThoseOfThisMachine) {
  const Listener other;
  const std::vector<std::string> all{"connects " + other.port(), "socket 1 1", "socket 2 1",
                                     "socket 2 2", "reads /etc/hosts"};
  EXPECT_EQ(done(at("unix:" + secret("socket")), with(all, "")), with(all, ": no"));
}

// What it says is held against what was asked; it can stop nothing but itself.
TEST_F(HttpClientTest, OutlivesWhatItsProgramSays) {
  HttpClient client(MJCOURSE_HOSTILE_NET, at("http://127.0.0.1:1"));
  // For a connection that it is not given, and as answers that nobody waits for.
  for (const std::string head :
       {"connect", "", "99 200 1", "-1 200", "0 200", "99999999999999999999999 2"}) {
    EXPECT_EQ(client.ask("GET", "ac/0", "says " + head).content, "said") << head;
  }
}

TEST_F(HttpClientTest, TellsOfTheEndOfItsProgram) {
  const Server server = at("http://127.0.0.1:1");
  const std::string ended = "the program that talks to the server has ended";
  EXPECT_EQ(done(server, "leaves"), ended + ": it had enough\n");
  EXPECT_EQ(done(server, "says promises"), ended);
  HttpClient client(MJCOURSE_HOSTILE_NET, server);
  client.ask("GET", "ac/0", "leaves");
  EXPECT_EQ(client.ask("GET", "ac/0", "is-root").trouble(), ended + ": it had enough");
  EXPECT_THROW(HttpClient("/none", server), std::system_error);
}

}  // namespace
}  // namespace mjcourse
