// Marking layouts: all data that determine the marks of a strip. Roads are cut lengthwise into strips, which are
// neighbouring lanes of one kind: a carriageway, a row of parking bays, a raised cycle track, a pavement, a railway.
// Strips with equal layouts share a column of the marking atlas.
//
//     v, metres along   12 |  |  :  |  |      u runs across from the strip's left edge as seen along the way, v along
//                          |  |  :  |  |      the way. Forward lanes are driven towards larger v.
//                        0 |  |  :  |  |
//                          0 -> u, metres across
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "compiler/map/cross_section.h"
#include "compiler/map/land_cover_class.h"
#include "compiler/roads/markings/mark.h"

namespace citykiln::roads {

/// The length after which a layout repeats along its strip. All periods of dashes, bays and sleepers divide it.
inline constexpr double kLayoutLength_m = 12;
/// The length of zebras, crossings and humps, which use the first part of their layout.
inline constexpr double kCrossingLength_m = 4;
inline constexpr double kStandardGauge_m = 1.435;

enum class StretchKind : std::uint8_t {
  kAlong,          ///< Between junctions; the layout repeats.
  kStart,          ///< Begins at a junction, at v = 0. It is kEnd for backward lanes.
  kEnd,            ///< Ends at a junction, at v = kLayoutLength_m.
  kZebra,          ///< Bars, where pedestrians have priority.
  kCrossing,       ///< Two broken lines, where pedestrians have a signal.
  kLevelCrossing,  ///< The strip of rails where a road crosses it.
  kHump,           ///< A speed hump across all lanes.
  kSpeedTable,     ///< A hump with a flat top.
  kSpeedCushions,  ///< A square hump in each lane.
};

/// True for humps of all kinds.
constexpr bool is_hump(StretchKind stretch) {
  return stretch == StretchKind::kHump || stretch == StretchKind::kSpeedTable || stretch == StretchKind::kSpeedCushions;
}

/// Traffic control at the junction where a stretch of kStart or kEnd lies.
enum class Control : std::uint8_t { kNone, kGiveWay, kStop, kSignals };

/// How a country paints its roads. It is not stored: practice_of() (marking_rules.h) has it by country group.
enum class MarkingPractice : std::uint8_t {
  kVienna,    ///< White lines, as the Vienna Convention on Road Signs and Signals has them.
  kAmerican,  ///< Yellow lines between opposite directions, crossings between two solid lines, rows of triangles where
              ///< traffic gives way (MUTCD).
  kJapanese,  ///< White lines, also along narrow streets without kerbs: they set off a strip for walkers.
};

struct MarkingLayout {
  map::LandCoverClass surface{};
  std::vector<map::Lane> lanes;  ///< The strip's lanes, left to right.
  StretchKind stretch = StretchKind::kAlong;
  Control control = Control::kNone;
  map::DrivingSide side = map::DrivingSide::kRight;
  MarkingPractice practice = MarkingPractice::kVienna;
  bool has_kerb_left = true, has_kerb_right = true;  ///< Larger roads without kerbs (out of town) get edge lines.
  double gauge_m = kStandardGauge_m;                 ///< Distance between the rails of kRail lanes.
  /// The marks and the width of a panel of a sports pitch (pitches/panels.h), which has no lanes; 0: a strip of lanes.
  Marks panel{};
  double panel_m = 0;
};

/// A total order over all members; doubles by std::strong_order.
std::strong_ordering operator<=>(const MarkingLayout& a, const MarkingLayout& b);
inline bool operator==(const MarkingLayout& a, const MarkingLayout& b) { return (a <=> b) == 0; }

/// The width of the strip: the sum of its lanes, or the width of the panel.
double width_m(const MarkingLayout& layout);
/// The value of u at the left side of each lane, then the strip's width: lanes.size() + 1 numbers.
std::vector<double> lane_sides_m(const MarkingLayout& layout);
/// The length of the layout along v: kCrossingLength_m for zebras and crossings, else kLayoutLength_m.
double length_m(const MarkingLayout& layout);

/// Returns the layout as seen against the way, rotated by 180°: its (u, v) is (width - u, length - v) of the given one.
MarkingLayout turned_round(const MarkingLayout& layout);

/// The lesser of a layout and its rotation, so that strips that differ only in the direction of their way share a
/// column.
struct CanonicalLayout {
  MarkingLayout layout;
  bool is_turned;  ///< True if (u, v) of the strip is (width - u, length - v) of the layout.
};
CanonicalLayout canonical_layout(const MarkingLayout& layout);

}  // namespace citykiln::roads
