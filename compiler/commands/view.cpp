// citykiln view OUT: shows the tileset of a run in a browser, by a server on 127.0.0.1 alone.
#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "compiler/commands/run_paths.h"
#include "compiler/commands/serve_module/serve_io.h"
#include "compiler/commands/verb.h"
#include "compiler/commands/view/complete_page.h"
#include "compiler/commands/view/served_run.h"
#include "compiler/contract/system/load_module.h"
#include "exporters/run_files.h"

namespace citykiln::commands {
namespace {

constexpr std::int64_t kLastPort = 65535;

struct ViewRequest {
  PageRequest page;
  int port = 0;
  bool only_writes = false;
};

/// The data of the callbacks of the module.
struct Serving {
  const ServedRun& run;
  const Console& console;
  int port = 0;
};

CitykilnAnswer decide(void* owner, const CitykilnRequest* request) {
  const auto& serving = *static_cast<const Serving*>(owner);
  const ServedRun::Answer answer = serving.run.answer(request->host, request->path, serving.port);
  return {answer.status, answer.file, answer.type};
}

void listens(void* owner, int port) {
  auto& serving = *static_cast<Serving*>(owner);
  serving.port = port;
  const std::string url = fmt::format("http://127.0.0.1:{}/", port);
  serving.console.print_line(fmt::format("{}   (Ctrl-C ends)", url));
  serving.console.print_json(fmt::format(R"({{"url": "{}"}})", url));
  // the server runs until it is interrupted
  serving.console.end_json();
  std::fflush(stdout);
}

Error port_in_use(int port) {
  return {"--port", fmt::format("port {} is in use; give another one, or 0 for any", port)};
}

/// True if a server on this machine answers at a port.
bool is_answered(int port) {
  const int file = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (file < 0) return false;
  sockaddr_in address{};
  address.sin_family = AF_INET, address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const bool is_there = ::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  ::close(file);
  return is_there;
}

Result<Exit> serve(const ViewRequest& request, const Console& console) {
  const auto list = exporters::read_file_list(request.page.folder + "/" + exporters::kFileListName);
  if (!list) return list.error();
  const auto function = load_function("citykiln_serve.so", "citykiln_serve");
  if (!function) return function.error();
  const ServedRun run(request.page.folder, **list);
  Serving serving{run, console};
  const auto run_server = reinterpret_cast<decltype(&citykiln_serve)>(*function);
  if (run_server(request.port, &serving, decide, listens) == 0) return Exit::kDone;
  return port_in_use(request.port);
}

Result<Exit> run_view(const ViewRequest& asked, const Console& console) {
  if (asked.page.folder.empty()) return Error{"", "no folder is given; expected the folder of a run, such as out/town"};
  if (const Result<Done> fits = check_run_path(asked.page.folder); !fits) return fits.error();
  ViewRequest request = asked;
  request.page.folder = folder_of(asked.page.folder);
  std::error_code none;
  if (!std::filesystem::is_directory(request.page.folder, none))
    return Error{request.page.folder, "expected the folder of a run, found a file"};
  // before the tileset is baked, which may take minutes
  if (!request.only_writes && request.port > 0 && is_answered(request.port)) return port_in_use(request.port);
  if (const Result<Done> done = complete_page(request.page, console); !done) return done.error();
  return request.only_writes ? Result<Exit>(Exit::kDone) : serve(request, console);
}

}  // namespace

Verb view_verb() {
  const auto request = std::make_shared<ViewRequest>();
  Verb verb{"view", "shows a run in a browser, by a server on 127.0.0.1 alone", {}, {}};
  verb.options = {
      {"folder", "OUT", "folder of a run; without a tileset, one is baked into it first", false,
       store_text(request->page.folder)},
      {"--port", "N", "port of the server, 0 to 65535 (default: 0, any free one)", false,
       [request](const std::string& text) -> Result<Done> {
         const Result<std::int64_t> port = parse_whole(text, 0);
         if (!port || *port > kLastPort)
           return Error{"", fmt::format("expected a port from 0 to {}, found \"{}\"", kLastPort, text)};
         request->port = static_cast<int>(*port);
         return Done{};
       }},
      {"--write-only", "", "writes the page and ends; any static server can serve the folder", false,
       [request](const std::string& text) -> Result<Done> {
         request->only_writes = text == "true";
         return Done{};
       }},
      {"--geoid-height", "M|FILE.pgm", "for a tileset that is baked: as for compile", false,
       [request](const std::string& text) -> Result<Done> {
         Result<map::GeoidSource> geoid = map::parse_geoid(text);
         if (!geoid) return geoid.error();
         request->page.geoid = std::move(*geoid);
         return Done{};
       }},
      {"--lights", "N", "for a tileset that is baked: as for compile", false, store_whole(request->page.lights, 0)},
      {"--materials", "FOLDER", "for a tileset that is baked: as for compile", false,
       store_text(request->page.materials_folder)},
      threads_option(request->page.threads)};
  verb.examples = {"citykiln view out/town", "citykiln view out/town --port 8000",
                   "citykiln view out/town --write-only"};
  verb.run = [request](const Console& console) { return run_view(*request, console); };
  return verb;
}

}  // namespace citykiln::commands
