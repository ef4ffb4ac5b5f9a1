#include "compiler/commands/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace citykiln::commands {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 30;
/// Runs shorter than this show no bar.
constexpr auto kProgressDelay = std::chrono::seconds(1);
/// Shortest time between two updates of the bar.
constexpr auto kRedrawInterval = std::chrono::milliseconds(50);

/// A progress bar that redraws its own line and erases it at the end.
class ProgressBar {
 public:
  ProgressBar() : begin_(Clock::now()) {}
  ~ProgressBar() {
    if (is_drawn_) fmt::print(stderr, "\r\x1b[K");
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::string_view stage, double share) {
    const Clock::time_point now = Clock::now();
    if (now - begin_ < kProgressDelay || (is_drawn_ && now - drawn_ < kRedrawInterval)) return;
    const int filled = static_cast<int>(share * kBarWidth);
    fmt::print(stderr, "\r{:<22} [{:#<{}}{:.<{}}] {:3.0f} %\x1b[K", stage, "", filled, "", kBarWidth - filled,
               share * 100);
    std::fflush(stderr);
    is_drawn_ = true;
    drawn_ = now;
  }

 private:
  Clock::time_point begin_, drawn_;
  bool is_drawn_ = false;
};

}  // namespace

void Console::print_line(std::string_view line) const {
  if (!is_quiet && !is_json) fmt::print("{}\n", line);
}

void Console::print_json(std::string_view json) const {
  if (is_json) fmt::print("{}\n", json);
}

OnProgress Console::progress() const {
  if (is_quiet || is_json || isatty(STDERR_FILENO) == 0) return [](std::string_view, double) {};
  return [bar = std::make_shared<ProgressBar>()](std::string_view stage, double share) { bar->show(stage, share); };
}

}  // namespace citykiln::commands
