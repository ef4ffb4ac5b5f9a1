// Runs the server of a site until the process ends.
#pragma once

#include <string>

#include "compiler/commands/console.h"
#include "compiler/commands/serve/site.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {

/// The choices of a server.
struct ServerRequest {
  std::string address = "127.0.0.1";
  int port = 0;  ///< 0: any free one.
  std::string allowed_origin{};
  bool logs_requests = false;  ///< A line for each request; else one a minute.
};

/// Serves a site: prints its address, then a line a minute about what it does. On a loopback address it answers only
/// requests for this machine by name. Errors: a port that is in use, an address that is not of this machine.
Result<Exit> run_server(const Site& site, const ServerRequest& request, const Console& console);

/// Tests whether the port is free, before long work. Error: it is in use. Costs a look.
Result<Done> check_port(const ServerRequest& request);

/// Returns a function that stores a port, 0 to 65535.
StoreValue store_port(int& port);

}  // namespace citykiln::commands
