// Parses dates and times.
#pragma once

#include <string>

#include "compiler/contract/result.h"

namespace citykiln::sky {

/// A moment in UTC.
struct Moment {
  std::string text;  ///< The given text if it was in UTC, else converted to "2026-06-21T18:30:00Z".
  double days = 0;   ///< Days since J2000.0, 2000-01-01T12:00.
};

/// Parses "2026-06-21T15:00": seconds, and an offset from UTC ("Z", "+02:00", "-0330", "+02") are optional.
///
/// Errors: another form; a date or time that the calendar does not have; a leap second; an offset beyond 14 hours; a
/// moment that is not in the years 0 to 9999.
Result<Moment> parse_time(const std::string& text);

}  // namespace citykiln::sky
