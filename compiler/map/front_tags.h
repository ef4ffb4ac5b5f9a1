// Shop fronts: the ground floor of a shop, restaurant, office or workshop that is mapped as a point.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// The kind of a front, by the things sold, served or done behind it: a row of fronts.inc.
enum class FrontKind : std::uint8_t {
#define FRONT_KIND(name, ...) name,
#define FRONT(...)
#include "compiler/map/fronts.inc"
#undef FRONT
#undef FRONT_KIND
  kCount
};

/// The number of colours of a kind's fascia.
inline constexpr std::size_t kFasciaColours = 6;

/// The hours at which a front is open: opening and closing on weekdays, Saturdays and Sundays, in quarter hours after
/// midnight. Closing may be after 96, the next midnight; both are equal on a day on which it is closed.
struct FrontHours {
  std::array<std::uint8_t, 6> quarters{};
  bool operator==(const FrontHours&) const = default;
};

/// The latest closing: six o'clock of the next morning.
inline constexpr std::uint8_t kLatestClosing = 120;

/// A row of the table FRONT_KIND of fronts.inc.
struct FrontValues {
  std::string_view name;
  FrontHours hours;
  double lit_share;  ///< The share whose windows stay lit after closing.
  std::array<std::string_view, kFasciaColours> colours;
};
/// Returns the row of a kind.
const FrontValues& values_of(FrontKind kind);

/// The front of a point: its kind, and its hours if they are tagged in a simple form.
struct FrontTags {
  FrontKind kind{};
  std::optional<FrontHours> hours{};
  bool operator==(const FrontTags&) const = default;
};

/// Returns the front by the tags shop, amenity, office, craft and opening_hours; nothing if they name none, or if the
/// point is not on the ground floor, inside a larger building (indoor=*), or gone (standing.h).
std::optional<FrontTags> read_front_tags(const source::OsmData& osm, source::Range tags);

/// Returns the hours in a text such as "24/7", "Mo-Fr 08:00-18:00; Sa 10:00-16:00" or "Mo-Su 11:00-15:00,18:00-23:00",
/// of which the first opening and the last closing count. Wednesday stands for the weekdays. Nothing for a text of
/// another form, with months, weeks or comments for instance.
std::optional<FrontHours> front_hours_of(std::string_view text);

}  // namespace citykiln::map
