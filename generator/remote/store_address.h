// The address of a shared store, as its parts.
//
// Where a name and a password end is for two to say: whoever shows an address without them, and
// libcurl, which asks there. So an address that the two could read otherwise is refused, libcurl is
// given the parts (remote/client/transfers.cpp), and what is shown never had a password in it.
// Tested by tests/generator/remote/store_address_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace mjcourse {

struct StoreAddress {
  std::string url;     // of the folder with ac/ and cas/, with no name and no slash at its end
  std::string socket;  // the path of a socket, for `unix:`
  // As they stand in an address, percent-encoded; empty where there are none. Secrets.
  std::string user, password;

  // For people.
  std::string shown() const;
  // Of http and https: a name, or a number without brackets; and where TCP goes to.
  std::string host() const;
  std::uint16_t port() const;
};

// Of http://…, https://… and unix:/path. What is wrong with it never has a part of it, which may be
// one of a password.
tl::expected<StoreAddress, std::string> read_store_address(std::string_view text);

// `text`, which may be anything that a user wrote, without the name and the password of an address
// in it: "https://…@host".
std::string without_userinfo(std::string text);

}  // namespace mjcourse
