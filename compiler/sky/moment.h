// Moments: dates and times, and their texts.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/result.h"

namespace citykiln::sky {

/// The end of a moment's text: nothing, or "Z". Greater numbers stand for the forms of "+00:00".
inline constexpr std::uint8_t kNoEnding = 0, kEndingZ = 1;

/// A moment in UTC, and the form of its text.
struct Moment {
  std::chrono::sys_seconds at{};
  bool has_seconds = false;  ///< The text is "15:00:00" in place of "15:00". False only for whole minutes.
  std::uint8_t ending = kNoEnding;
  bool operator==(const Moment&) const = default;
};

/// Returns a minute of a day in UTC, whose text is like "2026-06-21T15:00" with the ending.
constexpr Moment moment_of(std::chrono::sys_days day, int minute, std::uint8_t ending = kNoEnding) {
  return {day + std::chrono::minutes(minute), false, ending};
}

/// Parses "2026-06-21T15:00": seconds, and an offset from UTC ("Z", "+02:00", "-0330", "+02") are optional.
///
/// Errors: another form; a date or time that the calendar does not have; a leap second; an offset beyond 14 hours; a
/// moment that is not in the years 0 to 9999.
Result<Moment> parse_time(std::string_view text);

/// Returns the text of a moment, which parse_time() reads as that moment: the parsed text if it was in UTC, else
/// "2026-06-21T18:30:00Z". Empty for no moment.
std::string text_of(const std::optional<Moment>& moment);

/// Returns the days since J2000.0, 2000-01-01T12:00.
double days_of(const Moment& moment);

}  // namespace citykiln::sky
