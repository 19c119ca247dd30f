// Whether the proxies that the environment names can be told of.
//
// libcurl takes their addresses from the variables by itself. Of one that it cannot read it tells
// with all that the variable holds, and of one that it reads otherwise than it was meant, with a
// part of the password as a host.
// Tested by tests/store/secrets.mjs.
#pragma once

#include <string>

namespace mjcourse {

// Why a request of `url` may have come to nothing because of the proxy that is named for it; empty
// where that has an address, or where there is none. It repeats nothing that the variable holds.
std::string proxy_fault(const std::string& url);

}  // namespace mjcourse
