#include "compiler/sky/moment.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace citykiln::sky {
namespace {

// The endings of texts in UTC, by Moment::ending.
constexpr std::array<std::string_view, 8> kEndings = {"", "Z", "+00:00", "+0000", "+00", "-00:00", "-0000", "-00"};
constexpr double kUnixEpoch = 2440587.5, kJ2000 = 2451545.0;  // Julian dates
constexpr int kLargestOffset_min = 14 * 60;                   // Line Islands; all others are smaller

/// Reads a text from left to right. After the first mismatch is_right() stays false.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  int number(int digits) {
    int value = 0;
    for (int i = 0; i < digits; ++i) {
      const bool is_digit = at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9';
      if (!is_digit) return is_right_ = false, 0;
      value = value * 10 + (text_[at_++] - '0');
    }
    return value;
  }
  bool skip(char c) {
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) { is_right_ = skip(c) && is_right_; }
  bool is_at_end() const { return at_ == text_.size(); }
  bool is_right() const { return is_right_; }
  std::string_view rest() const { return text_.substr(at_); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  bool is_right_ = true;
};

struct Fields {
  int year, month, day, hour, minute, second = 0;
  bool has_seconds = false;
  int offset_min = 0;
  std::uint8_t ending = 0;  // kEndingZ for an offset other than 0
};

// Minutes east of UTC: "Z", "+02:00", "+0200", "+02" or nothing.
int read_offset_min(Cursor& cursor) {
  if (cursor.is_at_end() || cursor.skip('Z')) return 0;
  const bool is_west = cursor.skip('-');
  if (!is_west) cursor.expect('+');
  const int hours = cursor.number(2);
  const bool has_minutes = cursor.skip(':') || !cursor.is_at_end();
  const int minutes = has_minutes ? cursor.number(2) : 0;
  // more than an hour's minutes become an offset that is refused
  const int offset_min = minutes < 60 ? hours * 60 + minutes : 2 * kLargestOffset_min;
  return is_west ? -offset_min : offset_min;
}

std::uint8_t ending_of(std::string_view text) {
  const auto found = std::ranges::find(kEndings, text);
  return static_cast<std::uint8_t>(found == kEndings.end() ? kEndingZ : found - kEndings.begin());
}

std::optional<Fields> read_fields(std::string_view text) {
  Cursor cursor(text);
  Fields f{};
  f.year = cursor.number(4), cursor.expect('-');
  f.month = cursor.number(2), cursor.expect('-');
  f.day = cursor.number(2), cursor.expect('T');
  f.hour = cursor.number(2), cursor.expect(':');
  f.minute = cursor.number(2);
  if (cursor.skip(':')) f.has_seconds = true, f.second = cursor.number(2);
  f.ending = ending_of(cursor.rest());
  f.offset_min = read_offset_min(cursor);
  return cursor.is_right() && cursor.is_at_end() ? std::optional(f) : std::nullopt;
}

}  // namespace

Result<Moment> parse_time(std::string_view text) {
  const auto error = [&](const char* message) { return Error{std::string(text), message}; };
  const std::optional<Fields> f = read_fields(text);
  if (!f) return error("expected a time like 2026-06-21T15:00 (UTC) or 2026-06-21T17:00+02:00, with seconds or not");
  const std::chrono::year_month_day date{std::chrono::year(f->year),
                                         std::chrono::month(static_cast<unsigned>(f->month)),
                                         std::chrono::day(static_cast<unsigned>(f->day))};
  if (!date.ok()) return error("the calendar has no such date");
  if (f->second == 60) return error("leap seconds are not supported; give second 59");
  if (f->hour > 23 || f->minute > 59 || f->second > 59) return error("expected a time from 00:00:00 to 23:59:59");
  if (std::abs(f->offset_min) > kLargestOffset_min)
    return error("expected an offset from UTC of -14:00 to +14:00, with minutes up to 59");
  const std::chrono::sys_seconds at = std::chrono::sys_days(date) + std::chrono::hours(f->hour) +
                                      std::chrono::minutes(f->minute - f->offset_min) + std::chrono::seconds(f->second);
  const auto year = std::chrono::year_month_day(std::chrono::floor<std::chrono::days>(at)).year();
  if (year < std::chrono::year(0) || year > std::chrono::year(9999))
    return error("expected a moment in the years 0 to 9999, in UTC");
  return Moment{at, f->has_seconds || f->offset_min != 0, f->ending};
}

std::string text_of(const std::optional<Moment>& moment) {
  if (!moment) return "";
  const auto day = std::chrono::floor<std::chrono::days>(moment->at);
  const std::chrono::year_month_day date(day);
  const std::chrono::hh_mm_ss time(moment->at - day);
  const std::string seconds = moment->has_seconds ? fmt::format(":{:02}", time.seconds().count()) : "";
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}{}{}", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), time.hours().count(),
                     time.minutes().count(), seconds, kEndings[moment->ending]);
}

double days_of(const Moment& moment) {
  return static_cast<double>(moment.at.time_since_epoch().count()) / 86400 + kUnixEpoch - kJ2000;
}

}  // namespace citykiln::sky
