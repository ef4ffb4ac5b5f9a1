#include "compiler/commands/console.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "compiler/contract/texts/parse.h"

namespace citykiln::commands {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kBarWidth = 30;
/// Runs shorter than this show no bar.
constexpr auto kProgressDelay = std::chrono::seconds(1);
/// Shortest time between two updates of the bar.
constexpr auto kRedrawInterval = std::chrono::milliseconds(50);

/// Share of a stage from which on its time left is estimated, and shortest time spent in it.
constexpr double kLeastShare = 0.02;
constexpr auto kLeastTime = std::chrono::seconds(2);

/// Returns ", 1:05 left", for a stage that continues at the same speed; "" while that is unknown.
std::string time_left(Clock::duration spent, double share) {
  if (share < kLeastShare || spent < kLeastTime) return "";
  const double left_s = std::chrono::duration<double>(spent).count() * (1 - share) / share;
  const auto whole_s = static_cast<long>(left_s + 0.5);
  return fmt::format(", {}:{:02} left", whole_s / 60, whole_s % 60);
}

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
    if (stage != stage_) stage_ = stage, stage_begin_ = now;
    if (now - begin_ < kProgressDelay || (is_drawn_ && now - drawn_ < kRedrawInterval)) return;
    const int filled = static_cast<int>(share * kBarWidth);
    fmt::print(stderr, "\r{:<22} [{:#<{}}{:.<{}}] {:3.0f} %{}\x1b[K", stage, "", filled, "", kBarWidth - filled,
               share * 100, time_left(now - stage_begin_, share));
    std::fflush(stderr);
    is_drawn_ = true;
    drawn_ = now;
  }

 private:
  Clock::time_point begin_, stage_begin_, drawn_;
  std::string stage_;
  bool is_drawn_ = false;
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
  if (!is_quiet && !is_json) fmt::print("{}\n", line);
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
