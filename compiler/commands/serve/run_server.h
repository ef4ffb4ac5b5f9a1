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

/// Serves a site until the process ends. Prints its address, then a line for each minute with requests. On a loopback
/// address it answers 403 to requests whose header Host fails is_own_host(). Errors: a port that is in use, an address
/// that is not of this machine, a server module (citykiln_serve.so) that cannot be loaded.
Result<Exit> run_server(const Site& site, const ServerRequest& request, const Console& console);

/// Opens a site, with progress, and serves it until the process ends. Errors: those of Site::open() and run_server().
Result<Exit> serve_site(const SiteRequest& site, const ServerRequest& request, const Console& console);

/// Tests, before long work, that no server answers at the port. Error: one does. Tests nothing for port 0 or an address
/// that is not loopback. Costs one attempt to connect.
Result<Done> check_port(const ServerRequest& request);

/// Returns a function that stores a port, 0 to 65535.
StoreValue store_port(int& port);

}  // namespace citykiln::commands
