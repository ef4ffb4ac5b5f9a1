#include "compiler/commands/serve/run_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <stop_token>
#include <thread>

#include "compiler/contract/system/load_module.h"

namespace citykiln::commands {
namespace {

constexpr std::int64_t kLastPort = 65535;
constexpr std::chrono::minutes kBetweenLines{1};

bool is_loopback(const std::string& address) { return address.starts_with("127.") || address == "localhost"; }

Error port_in_use(const ServerRequest& request) {
  return {"--port", fmt::format("port {} is in use; give another one, or 0 for any", request.port)};
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

/// A server at work, and what it tells about it.
class Serving {
 public:
  Serving(const Site& site, const ServerRequest& request, const Console& console)
      : site_(site), request_(request), console_(console) {}

  HttpAnswer decide(const HttpRequest& asked) const {
    if (is_loopback(request_.address) && !is_own_host(asked.host, port_)) return {.status = 403};
    return site_.answer(asked);
  }

  void listens(int port) {
    port_ = port;
    const std::string url = fmt::format("http://{}:{}/", request_.address, port);
    console_.print_line(fmt::format("{}   (Ctrl-C ends)", url));
    console_.print_json(fmt::format(R"({{"url": "{}"}})", url));
    // the server runs until it is interrupted
    console_.end_json();
    std::fflush(stdout);
    preparing_ = std::jthread([this] { site_.prepare(); });
    telling_ = std::jthread([this](const std::stop_token& stop) { tell(stop); });
  }

  void answered(const std::string& path, int status) {
    ++answers_;
    if (!request_.logs_requests) return;
    console_.print_line(fmt::format("{} {}", status, path));
    std::fflush(stdout);
  }

 private:
  // A line a minute, if anything was asked for.
  void tell(const std::stop_token& stop) {
    std::mutex mutex;
    std::condition_variable_any never;
    std::unique_lock lock(mutex);
    std::uint64_t told = 0;
    while (!never.wait_for(lock, stop, kBetweenLines, [] { return false; }) && !stop.stop_requested()) {
      const std::uint64_t answers = answers_;
      if (answers == told) continue;
      const ContentCache::Counters c = site_.counters();
      console_.print_line(fmt::format("{} requests: {} contents made, {} from the cache of {:.0f} MB, {} given up",
                                      answers - told, c.made, c.found, static_cast<double>(c.bytes) * 1e-6,
                                      c.given_up));
      if (c.failed > 0) console_.print_line(fmt::format("{} contents failed, the latest: {}", c.failed, c.failure));
      std::fflush(stdout);
      told = answers;
    }
  }

  const Site& site_;
  const ServerRequest& request_;
  const Console& console_;
  std::atomic<int> port_ = 0;
  std::atomic<std::uint64_t> answers_ = 0;
  std::jthread preparing_, telling_;
};

}  // namespace

Result<Exit> run_server(const Site& site, const ServerRequest& request, const Console& console) {
  const auto function = load_function("citykiln_serve.so", "citykiln_serve");
  if (!function) return function.error();
  Serving serving(site, request, console);
  const HttpServer server{.address = request.address,
                          .port = request.port,
                          .allowed_origin = request.allowed_origin,
                          .decide = [&](const HttpRequest& asked) { return serving.decide(asked); },
                          .listens = [&](int port) { serving.listens(port); },
                          .answered = [&](const std::string& path, int status) { serving.answered(path, status); }};
  const auto run = reinterpret_cast<decltype(&citykiln_serve)>(*function);
  if (run(server) == 0) return Exit::kDone;
  if (request.port > 0 && is_answered(request.port)) return port_in_use(request);
  return Error{"--listen", fmt::format("cannot listen at {}, port {}", request.address, request.port)};
}

Result<Exit> serve_site(const SiteRequest& site, const ServerRequest& request, const Console& console) {
  OnProgress on_progress = console.progress();
  on_progress("open the scene", 0);
  const Result<std::unique_ptr<Site>> opened = Site::open(site);
  on_progress = {};
  if (!opened) return opened.error();
  const InterruptNotice notice("the server has ended; it wrote nothing");
  return run_server(**opened, request, console);
}

Result<Done> check_port(const ServerRequest& request) {
  if (request.port > 0 && is_loopback(request.address) && is_answered(request.port)) return port_in_use(request);
  return Done{};
}

StoreValue store_port(int& port) {
  return [&port](const std::string& text) -> Result<Done> {
    const Result<std::int64_t> given = parse_whole(text, 0);
    if (!given || *given > kLastPort)
      return Error{"", fmt::format("expected a port from 0 to {}, found \"{}\"", kLastPort, text)};
    port = static_cast<int>(*given);
    return Done{};
  };
}

}  // namespace citykiln::commands
