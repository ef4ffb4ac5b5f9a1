// The interface of the module that answers HTTP. It is loaded at run time, since only `view` and `serve` need it.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace citykiln::commands {

using SharedBytes = std::shared_ptr<const std::vector<std::byte>>;
/// False once the client has gone. Costs a look at its socket.
using IsWanted = std::function<bool()>;

struct HttpRequest {
  std::string host;  ///< The header Host; empty without one.
  std::string path;  ///< "/page/page.json": with "%.." decoded and without "?…".
  std::string etag;  ///< The header If-None-Match; empty without one.
};

/// The answer to a request: a status alone, a file, or bytes that are made when they are sent.
struct HttpAnswer {
  int status = 404;
  std::string type{};  ///< The media type.
  std::string etag{};  ///< With quotation marks; empty: none.
  std::string file{};  ///< The path of the file to send.
  /// Returns the bytes to send; null if they are not wanted any more, or cannot be made.
  std::function<SharedBytes(const IsWanted& is_wanted)> make{};
};

/// The settings of a server.
struct HttpServer {
  std::string address = "127.0.0.1";
  int port = 0;                  ///< 0: any free port.
  std::string allowed_origin{};  ///< The header Access-Control-Allow-Origin; empty: pages of this server alone.
  /// Decides on an answer; may be called from several threads at once.
  std::function<HttpAnswer(const HttpRequest& request)> decide;
  std::function<void(int port)> listens;  ///< Called once, when the server listens.
  /// Receives the path and the status of each answer; may be called from several threads at once.
  std::function<void(const std::string& path, int status)> answered;
};

/// Answers GET and HEAD until the process ends. Ranges are answered here; decide() compares If-None-Match. JSON and
/// JavaScript are compressed with gzip for clients that accept it. Files are read into memory whole. Returns 1 if the
/// address and port cannot be used or listening fails.
extern "C" int citykiln_serve(const HttpServer& server);

}  // namespace citykiln::commands
