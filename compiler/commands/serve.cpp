// citykiln serve SCENE.kiln|OUT: serves the 3D Tiles of a scene to programs, without a page.
#include <memory>

#include "compiler/commands/serve/run_server.h"
#include "compiler/commands/serve/site_options.h"
#include "compiler/commands/verb.h"

namespace citykiln::commands {
namespace {

constexpr int kUsualPort = 8080;

struct ServeRequest {
  SiteChoices choices;
  ServerRequest server{.port = kUsualPort};
};

Result<Exit> run_serve(const ServeRequest& request, const Console& console) {
  const Result<SiteRequest> asked = site_request(request.choices, false);
  if (!asked) return asked.error();
  if (const Result<Done> free = check_port(request.server); !free) return free.error();
  return serve_site(*asked, request.server, console);
}

}  // namespace

Verb serve_verb() {
  const auto request = std::make_shared<ServeRequest>();
  Verb verb{"serve", "serves the 3D Tiles of a scene to CesiumJS, three.js and engines", {}, {}};
  verb.options = site_options(request->choices);
  const std::vector<Option> own = {
      {"--port", "N", "port of the server, 0 for any free one (default: 8080)", false,
       store_port(request->server.port)},
      {"--listen", "ADDRESS", "address to listen at, such as 0.0.0.0 for all (default: 127.0.0.1, this machine alone)",
       false, store_text(request->server.address)},
      {"--cors", "ORIGIN", "pages that may read the tiles, such as https://example.org, or * for all", false,
       store_text(request->server.allowed_origin)},
      {"--log-requests", "", "prints a line for each request", false,
       [request](const std::string& text) -> Result<Done> {
         request->server.logs_requests = text == "true";
         return Done{};
       }}};
  verb.options.insert(verb.options.end(), own.begin(), own.end());
  verb.examples = {"citykiln serve out/town/scene.kiln", "citykiln serve out/town --cors '*' --port 9000"};
  verb.run = [request](const Console& console) { return run_serve(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
