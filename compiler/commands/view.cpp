// citykiln view SCENE.kiln|OUT: shows a scene in a browser, by a server on 127.0.0.1 alone.
#include <memory>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/serve/run_server.h"
#include "compiler/commands/serve/site_options.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/complete_page.h"

namespace citykiln::commands {
namespace {

struct ViewRequest {
  SiteChoices choices;
  ServerRequest server;
  bool only_writes = false;
};

Result<Exit> write_page_into(const SiteRequest& site) {
  return Error{site.path, "is a manifest alone; --write-only needs the folder of a run"};
}

Result<Exit> run_view(const ViewRequest& request, const Console& console) {
  const Result<SiteRequest> asked = site_request(request.choices, true);
  if (!asked) return asked.error();
  if (request.only_writes) {
    if (asked->path.ends_with(".kiln")) return write_page_into(*asked);
    const Result<Done> done = complete_page({asked->path, asked->outputs, asked->threads}, console);
    return done ? Result<Exit>(Exit::kDone) : done.error();
  }
  if (const Result<Done> free = check_port(request.server); !free) return free.error();
  return serve_site(*asked, request.server, console);
}

}  // namespace

Verb view_verb() {
  const auto request = std::make_shared<ViewRequest>();
  Verb verb{"view", "shows a scene in a browser, by a server on 127.0.0.1 alone", {}, {}};
  verb.options = site_options(request->choices);
  verb.options.push_back({"--port", "N", "port of the server, 0 to 65535 (default: 0, any free one)", false,
                          store_port(request->server.port)});
  verb.options.push_back(
      {"--write-only", "",
       "writes the page into the folder of a run, with a tileset if it has none, and ends; any static "
       "server can serve the folder",
       false, [request](const std::string& text) -> Result<Done> {
         request->only_writes = text == "true";
         return Done{};
       }});
  verb.examples = {"citykiln view out/town", "citykiln view out/town/scene.kiln --port 8000",
                   "citykiln view out/town --write-only"};
  verb.run = [request](const Console& console) { return run_view(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
