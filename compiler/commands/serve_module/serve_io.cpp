#include "compiler/commands/serve_module/serve_io.h"

#include <httplib.h>
#include <zlib.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>

namespace citykiln::commands {
namespace {

// Browsers keep six connections open; requests that wait for a content to be baked need one each.
constexpr std::size_t kConnections = 64;
// A browser that is busy with other tiles reads nothing meanwhile; the library would give up after five seconds.
constexpr std::chrono::minutes kWriteTimeout{5};

bool is_text(const std::string& type) {
  return type.starts_with("application/json") || type.starts_with("application/javascript");
}

std::string gzipped(const std::string& text) {
  constexpr int kGzip = 15 + 16, kMemory = 8;  // the window with a gzip header; both as zlib has them by default
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data()), stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

// The library would compress these with Brotli at its highest level, which takes two seconds for the page's script. It
// leaves types alone that name a charset, but for text/.
void send(std::string content, const std::string& type, const httplib::Request& request, httplib::Response& response) {
  const bool is_packed = is_text(type) && request.get_header_value("Accept-Encoding").find("gzip") != std::string::npos;
  if (is_packed) response.set_header("Content-Encoding", "gzip");
  if (is_text(type)) response.set_header("Vary", "Accept-Encoding");
  response.set_content(is_packed ? gzipped(content) : std::move(content), type);
}

void send_file(const HttpAnswer& answer, const httplib::Request& request, httplib::Response& response) {
  std::ifstream file(answer.file, std::ios::binary);
  if (!file) {
    response.status = 404;
    return;
  }
  send(std::string(std::istreambuf_iterator<char>(file), {}), answer.type, request, response);
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
  // a length, a part or a compressed text needs the whole first
  const bool can_wait = request.method == "GET" && !request.has_header("Range") && answer.type == "model/gltf-binary";
  if (can_wait) return send_when_made(answer, response);
  const SharedBytes bytes = answer.make([] { return true; });
  if (bytes)
    send({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, answer.type, request, response);
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
    send_file(answer, request, response);
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
  http.set_write_timeout(kWriteTimeout);
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
