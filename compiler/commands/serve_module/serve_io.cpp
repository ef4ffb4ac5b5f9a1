#include "compiler/commands/serve_module/serve_io.h"

#include <httplib.h>

#include <fstream>
#include <iterator>
#include <memory>

namespace citykiln::commands {
namespace {

// Browsers keep six connections open; requests that wait for a content to be baked need one each.
constexpr std::size_t kConnections = 64;

void send_file(const HttpAnswer& answer, httplib::Response& response) {
  std::ifstream file(answer.file, std::ios::binary);
  if (!file) {
    response.status = 404;
    return;
  }
  response.set_content(std::string(std::istreambuf_iterator<char>(file), {}), answer.type);
}

void send_bytes(const std::vector<std::byte>& bytes, const std::string& type, httplib::Response& response) {
  response.set_content(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), type);
}

// Sends bytes that are made while the client waits, in chunks, and stops making them if it goes.
void send_when_made(const HttpAnswer& answer, httplib::Response& response) {
  response.set_chunked_content_provider(answer.type, [make = answer.make](std::size_t, httplib::DataSink& sink) {
    const SharedBytes bytes = make([&sink] { return sink.is_writable(); });
    if (!bytes || !sink.write(reinterpret_cast<const char*>(bytes->data()), bytes->size())) return false;
    sink.done();
    return true;
  });
}

void send_made(const HttpAnswer& answer, const httplib::Request& request, httplib::Response& response) {
  // a length or a part needs the whole first; texts are compressed, which chunks of this library are not
  const bool is_text = answer.type != "model/gltf-binary";
  if (request.method == "GET" && !request.has_header("Range") && !is_text) return send_when_made(answer, response);
  const SharedBytes bytes = answer.make([] { return true; });
  if (bytes)
    send_bytes(*bytes, answer.type, response);
  else
    response.status = 500;
}

void answer(const HttpServer& server, const httplib::Request& request, httplib::Response& response) {
  // the library decides between 200 and 206
  const HttpRequest asked{request.get_header_value("Host"), request.path, request.get_header_value("If-None-Match")};
  const HttpAnswer answer = server.decide(asked);
  if (!answer.etag.empty()) response.set_header("ETag", answer.etag);
  if (answer.status != 200) {
    response.status = answer.status;
    return;
  }
  if (answer.make)
    send_made(answer, request, response);
  else
    send_file(answer, response);
}

// Without SO_REUSEPORT, by which two servers could share a port and each answer some of the requests.
void set_socket(socket_t socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
}

httplib::Headers headers_of(const HttpServer& server) {
  httplib::Headers headers = {{"Cache-Control", "no-cache"}, {"X-Content-Type-Options", "nosniff"}};
  if (server.allowed_origin.empty())
    headers.emplace("Cross-Origin-Resource-Policy", "same-origin");
  else
    headers.emplace("Access-Control-Allow-Origin", server.allowed_origin);
  return headers;
}

}  // namespace

int citykiln_serve(const HttpServer& server) {
  httplib::Server http;
  http.new_task_queue = [] { return new httplib::ThreadPool(kConnections); };
  http.set_tcp_nodelay(true);
  http.set_socket_options(set_socket);
  http.set_default_headers(headers_of(server));
  http.Get(".*",
           [&](const httplib::Request& request, httplib::Response& response) { answer(server, request, response); });
  http.set_logger([&](const httplib::Request& request, const httplib::Response& response) {
    server.answered(request.path, response.status);
  });
  int port = server.port;
  if (port == 0) {
    port = http.bind_to_any_port(server.address);
    if (port < 0) return 1;
  } else if (!http.bind_to_port(server.address, port)) {
    return 1;
  }
  server.listens(port);
  return http.listen_after_bind() ? 0 : 1;
}

}  // namespace citykiln::commands
