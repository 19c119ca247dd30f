// The name and password for a host in a file like ~/.netrc, as libcurl and ftp read it.
//
// The generator reads it, so that the program that talks to a server knows those of that server
// alone. Tested by tests/generator/remote/netrc_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace mjcourse {

struct Login {
  std::string user, password;
};

// Of the first that has both, for `host` or for any; with `user`, of that one's. Nothing where
// there is none.
std::optional<Login> login_in(std::string_view netrc, std::string_view host, std::string_view user);

}  // namespace mjcourse
