// How `mjcourse-net` is started: what it may do, and what it knows.
//
// It takes what a server sends, with libraries that are large. So it is confined as if it were
// somebody else's. It reads the system's libraries, certificates and names of hosts; it writes
// nothing, starts nothing, and connects to the ports of the store, of proxies and of name servers.
// Of secrets, it has those of the one server and of proxies, and it gets the former by its first
// message. Where the store is a socket of this machine, it makes none at all: it is given them.
// Tested by tests/generator/remote/http_client_test.cpp.
#pragma once

#include <filesystem>

#include "process/subprocess.h"
#include "remote/store_address.h"

namespace mjcourse {

Command net_command(const std::filesystem::path& program, const StoreAddress& address);

}  // namespace mjcourse
