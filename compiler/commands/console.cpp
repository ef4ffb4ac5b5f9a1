#include "compiler/commands/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace citykiln::commands {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 30;
/// Who is done within this time needs no bar.
constexpr auto kPatience = std::chrono::seconds(1);
/// Faster than the eye is waste.
constexpr auto kRedraw = std::chrono::milliseconds(50);

/// Draws over its own line and wipes it at the end.
class Bar {
 public:
  Bar() : begin_(Clock::now()) {}
  ~Bar() {
    if (is_drawn_) fmt::print(stderr, "\r\x1b[K");
  }
  Bar(const Bar&) = delete;
  Bar& operator=(const Bar&) = delete;

  void show(std::string_view stage, double share) {
    const Clock::time_point now = Clock::now();
    if (now - begin_ < kPatience || (is_drawn_ && now - drawn_ < kRedraw)) return;
    const int filled = static_cast<int>(share * kBarWidth);
    fmt::print(stderr, "\r{:<10} [{:#<{}}{:.<{}}] {:3.0f} %\x1b[K", stage, "", filled, "", kBarWidth - filled,
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

void Console::say(std::string_view line) const {
  if (!is_quiet && !speaks_json) fmt::print("{}\n", line);
}

void Console::answer(std::string_view json) const {
  if (speaks_json) fmt::print("{}\n", json);
}

OnProgress Console::progress() const {
  if (is_quiet || speaks_json || isatty(STDERR_FILENO) == 0) return [](std::string_view, double) {};
  return [bar = std::make_shared<Bar>()](std::string_view stage, double share) { bar->show(stage, share); };
}

}  // namespace citykiln::commands
