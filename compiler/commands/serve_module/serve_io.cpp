#include "compiler/commands/serve_module/serve_io.h"

#include <httplib.h>

#include <fstream>
#include <iterator>
#include <string>

namespace {

constexpr const char* kOnly = "127.0.0.1";

void send_file(const CitykilnAnswer& answer, httplib::Response& response) {
  std::ifstream file(answer.file, std::ios::binary);
  if (!file) {
    response.status = 404;
    return;
  }
  response.set_content(std::string(std::istreambuf_iterator<char>(file), {}), answer.type);
}

}  // namespace

int citykiln_serve(int port, void* owner, CitykilnDecide decide, CitykilnListens listens) {
  httplib::Server server;
  // without SO_REUSEPORT, by which two servers could share a port and each answer some of the requests
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  });
  server.set_default_headers({{"Cache-Control", "no-cache"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  server.Get(".*", [&](const httplib::Request& request, httplib::Response& response) {
    const std::string host = request.get_header_value("Host");
    const CitykilnRequest asked{host.c_str(), request.path.c_str()};
    const CitykilnAnswer answer = decide(owner, &asked);
    response.status = answer.status;
    if (answer.status == 200) send_file(answer, response);
  });
  if (port == 0) {
    port = server.bind_to_any_port(kOnly);
    if (port < 0) return 1;
  } else if (!server.bind_to_port(kOnly, port)) {
    return 1;
  }
  listens(owner, port);
  return server.listen_after_bind() ? 0 : 1;
}
