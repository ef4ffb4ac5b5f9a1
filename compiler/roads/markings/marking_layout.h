// Patterns: what is painted on a stretch of road, and nothing else about it. Roads are cut lengthwise into strips, runs
// of neighbouring lanes of one kind of surface: a carriageway, a row of parking bays, a raised cycle track, a pavement,
// a railway. Strips that look alike share one pattern.
//
//     v, metres along   12 |  |  :  |  |      a strip has coordinates: u across, from its left edge as seen along the
//                          |  |  :  |  |      way, v along. Forward lanes are driven towards larger v.
//                        0 |  |  :  |  |
//                          0 -> u, metres across
#pragma once

#include <compare>
#include <cstdint>
#include <vector>

#include "compiler/map/land_cover_class.h"
#include "compiler/map/lanes/lanes.h"

namespace citykiln::roads {

/// Along a strip every pattern repeats after this. All rhythms of dashes, bays and sleepers divide it.
inline constexpr double kLayoutLength_m = 12;
/// Zebras and crossings use the first metres of their pattern only; the rest is bare.
inline constexpr double kCrossingLength_m = 4;
inline constexpr double kStandardGauge_m = 1.435;

enum class StretchKind : std::uint8_t {
  kAlong,          ///< Between junctions; repeats for ever.
  kStart,          ///< v = 0 is where the strip leaves a junction: what kEnd is for forward lanes, for backward ones.
  kEnd,            ///< v = kLayoutLength_m is where the strip ends at a junction.
  kZebra,          ///< Pedestrians have priority: bars.
  kCrossing,       ///< Pedestrians have a signal: two broken lines.
  kLevelCrossing,  ///< Of the rails' strip: where a road runs over it.
};

/// What drivers meet at the junction of kStart and kEnd.
enum class Control : std::uint8_t { kNone, kGiveWay, kStop, kSignals };

struct MarkingLayout {
  map::LandCoverClass surface{};
  std::vector<map::Lane> lanes;  ///< Of one strip, left to right.
  StretchKind stretch = StretchKind::kAlong;
  Control control = Control::kNone;
  map::DrivingSide side = map::DrivingSide::kRight;
  bool has_kerb_left = true, has_kerb_right = true;  ///< In towns; where there is none, larger roads get edge lines.
  double gauge_m = kStandardGauge_m;                 ///< Of kRail lanes.
};

/// A total order, by all members; doubles by their bits' order.
std::strong_ordering operator<=>(const MarkingLayout& a, const MarkingLayout& b);
inline bool operator==(const MarkingLayout& a, const MarkingLayout& b) { return (a <=> b) == 0; }

double width_m(const MarkingLayout& layout);
/// u of each lane's left side, and last the strip's width: lanes.size() + 1 numbers.
std::vector<double> lane_sides_m(const MarkingLayout& layout);
/// How much of the pattern is used: kLayoutLength_m, or kCrossingLength_m.
double length_m(const MarkingLayout& layout);

/// The same strip as seen against the way: (u, v) there is (width - u, length - v) here. Its own inverse.
MarkingLayout turned_round(const MarkingLayout& layout);

/// The lesser of a pattern and itself turned round: two strips that only differ in which way their road was drawn share
/// its column.
struct CanonicalLayout {
  MarkingLayout layout;
  bool is_turned;  ///< Then the strip's (u, v) is (width - u, length - v) in the pattern.
};
CanonicalLayout canonical_layout(const MarkingLayout& layout);

}  // namespace citykiln::roads
