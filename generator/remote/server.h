// Where a shared store is, and as whom it is asked.
//
// What proves who asks is a secret: it stands in the environment, in ~/.netrc or in the address,
// and reaches no command line, message, report or key. Tested by
// tests/generator/remote/server_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "base/origin.h"
#include "remote/signature.h"
#include "remote/store_address.h"

namespace mjcourse {

struct Server {
  StoreAddress address;  // with the name and password of ~/.netrc, where it has none
  // From MJCOURSE_STORE_TOKEN; and what is in the files that MJCOURSE_STORE_CERTIFICATE, _KEY and
  // _AUTHORITIES name, the last for certificates to be trusted instead of the system's. Without it,
  // SSL_CERT_FILE names them. Empty where they are not set.
  std::string token, certificate, key, authorities;
  // From MJCOURSE_STORE_SIGNING_KEY, a file: signs what is put. From MJCOURSE_STORE_TRUSTED_KEYS,
  // public keys.
  std::optional<SigningKey> signing_key;
  std::vector<std::string> trusted_keys;

  // Where keys are trusted, nothing is believed but what one of them has signed. Nor is it by one
  // who signs, for whom others believe it: that one trusts its own key.
  Trust trust() const;
};

// What is wrong with the address or with the variables; it repeats nothing that they hold.
tl::expected<Server, std::string> server_at(const std::string& address);

// One without an address, for what the variables say of keys.
tl::expected<Server, std::string> no_server();

}  // namespace mjcourse
