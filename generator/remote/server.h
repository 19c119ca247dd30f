// Where a shared store is, and as whom it is asked.
//
// What proves who asks is a secret: it stands in the environment or in ~/.netrc, and reaches no
// command line, message, report or key.
// Tested by tests/generator/remote/server_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "remote/signature.h"
#include "remote/store_address.h"

namespace mjcourse {

struct Server {
  StoreAddress address;
  // From MJCOURSE_STORE_TOKEN, MJCOURSE_STORE_CERTIFICATE and _KEY (files), and _AUTHORITIES, a
  // file of certificates to be trusted instead of the system's. Empty where they are not set.
  std::string token, certificate, key, authorities;
  // From MJCOURSE_STORE_SIGNING_KEY, a file: signs what is put. From MJCOURSE_STORE_TRUSTED_KEYS,
  // public keys: where there are any, nothing is taken but what one of them has signed.
  std::optional<SigningKey> signing_key;
  std::vector<std::string> trusted_keys;
};

// What is wrong with the address or with the variables; it repeats nothing that they hold.
tl::expected<Server, std::string> server_at(const std::string& address);

}  // namespace mjcourse
