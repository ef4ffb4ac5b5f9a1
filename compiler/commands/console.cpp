#include "compiler/commands/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "compiler/contract/texts/parse.h"

namespace citykiln::commands {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 30;
/// Runs shorter than this show no bar.
constexpr auto kProgressDelay = std::chrono::seconds(1);
/// Time between two updates of the bar.
constexpr auto kRedrawInterval = std::chrono::milliseconds(100);

/// Share of a stage from which on its time left is estimated, and shortest time spent in it.
constexpr double kLeastShare = 0.02;
constexpr auto kLeastTime = std::chrono::seconds(2);

/// True while the last line of the terminal is a bar. Guarded by the mutex, which is locked while the line is written.
struct BarLine {
  std::mutex mutex;
  bool is_drawn = false;
};

BarLine& bar_line() {
  static BarLine line;
  return line;
}

/// Erases the bar, if there is one, so that a line of text can take its place.
void erase_bar() {
  const std::lock_guard lock(bar_line().mutex);
  if (std::exchange(bar_line().is_drawn, false)) fmt::print(stderr, "\r\x1b[K");
}

/// Returns "1:05".
std::string minutes_text(double seconds) {
  const auto whole_s = static_cast<long>(seconds + 0.5);
  return fmt::format("{}:{:02}", whole_s / 60, whole_s % 60);
}

/// Returns ", 1:05 left", for a stage that continues at the same speed; "" while that is unknown.
std::string time_left(Clock::duration spent, double share) {
  if (share < kLeastShare || spent < kLeastTime) return "";
  return fmt::format(", {} left", minutes_text(std::chrono::duration<double>(spent).count() * (1 - share) / share));
}

/// Returns a stage with its share and the time left; with the time spent, while nothing is known of its share.
std::string bar_text(std::string_view stage, double share, Clock::duration spent) {
  if (share <= 0 && spent >= kLeastTime)
    return fmt::format("{:<22} {} so far", stage, minutes_text(std::chrono::duration<double>(spent).count()));
  const int filled = static_cast<int>(share * kBarWidth);
  return fmt::format("{:<22} [{:#<{}}{:.<{}}] {:3.0f} %{}", stage, "", filled, "", kBarWidth - filled, share * 100,
                     time_left(spent, share));
}

/// A progress bar that a thread of its own redraws, so that stages that report nothing show that they go on. It is
/// erased at the end. Thread-safe.
class ProgressBar {
 public:
  ProgressBar() : drawing_([this](const std::stop_token& stop) { redraw(stop); }) {}
  ~ProgressBar() {
    drawing_ = {};
    erase_bar();
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::string_view stage, double share) {
    const std::lock_guard lock(mutex_);
    if (stage != stage_) stage_ = stage, stage_begin_ = Clock::now();
    share_ = share;
  }

 private:
  void redraw(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    for (auto wait = Clock::duration(kProgressDelay);; wait = kRedrawInterval) {
      changed_.wait_for(lock, stop, wait, [] { return false; });
      if (stop.stop_requested()) return;
      draw();
    }
  }

  void draw() const {
    if (stage_.empty()) return erase_bar();
    const std::lock_guard lock(bar_line().mutex);
    fmt::print(stderr, "\r{}\x1b[K", bar_text(stage_, share_, Clock::now() - stage_begin_));
    std::fflush(stderr);
    bar_line().is_drawn = true;
  }

  std::mutex mutex_;
  std::condition_variable_any changed_;
  Clock::time_point stage_begin_;
  std::string stage_;
  double share_ = 0;
  std::jthread drawing_;  // last: it uses the others
};

struct FileAndPlace {
  std::string file, place;
};

/// Splits the place of an error: "town.osm:12:5", "scene.kiln, byte 96", "--only", "town.osm".
FileAndPlace file_and_place(const std::string& where) {
  if (where.starts_with("--")) return {"", where};
  if (const std::size_t comma = where.find(", "); comma != std::string::npos)
    return {where.substr(0, comma), where.substr(comma + 2)};
  const std::size_t end = where.find_last_not_of("0123456789:");
  const std::size_t colon = end == std::string::npos ? end : where.find(':', end);
  if (colon == std::string::npos || colon + 1 == where.size()) return {where, ""};
  return {where.substr(0, colon), where.substr(colon + 1)};
}

}  // namespace

void Console::print_line(std::string_view line) const {
  if (is_quiet || is_json) return;
  erase_bar();
  fmt::print("{}\n", line);
}

void Console::print_json(std::string_view json) const {
  if (is_json) kept->values.emplace_back(json);
}

void Console::end_json() const {
  if (!is_json || std::exchange(kept->is_printed, true)) return;
  const std::vector<std::string>& values = kept->values;
  std::string text = values.size() == 1 ? values.front() : fmt::format("[{}]", fmt::join(values, ","));
  if (values.empty()) text = "{}";
  if (!kept->error.empty())
    text = values.empty() ? fmt::format(R"({{"error":{}}})", kept->error)
                          : fmt::format(R"({{"error":{},"result":{}}})", kept->error, text);
  while (text.ends_with('\n')) text.pop_back();
  fmt::print("{}\n", text);
  std::fflush(stdout);
}

void Console::print_error(const Error& error) const {
  // one line, even if a library's message has several; a list without a place has one for each item
  std::string text = to_string(error);
  erase_bar();
  if (!error.where.empty()) std::ranges::replace(text, '\n', ' ');
  for (const std::string_view line : split(text, '\n')) fmt::print(stderr, "citykiln: {}\n", line);
  if (!is_json) return;
  const auto [file, place] = file_and_place(error.where);
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? nlohmann::json() : nlohmann::json(text);
  };
  const nlohmann::ordered_json json = {
      {"file", text_or_null(file)}, {"place", text_or_null(place)}, {"message", error.message}};
  kept->error = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

OnProgress Console::progress() const {
  if (is_quiet || is_json || isatty(STDERR_FILENO) == 0) return [](std::string_view, double) {};
  return [bar = std::make_shared<ProgressBar>()](std::string_view stage, double share) { bar->show(stage, share); };
}

}  // namespace citykiln::commands
