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

#include "compiler/map/lanes/lanes.h"
#include "compiler/map/surface_class.h"

namespace citykiln::roads {

/// Along a strip every pattern repeats after this. All rhythms of dashes, bays and sleepers divide it.
inline constexpr double kPatternLength_m = 12;
/// Zebras and crossings use the first metres of their pattern only; the rest is bare.
inline constexpr double kCrossingLength_m = 4;
inline constexpr double kStandardGauge_m = 1.435;

enum class Stretch : std::uint8_t {
  kAlong,          ///< Between junctions; repeats for ever.
  kStart,          ///< v = 0 is where the strip leaves a junction: what kEnd is for forward lanes, for backward ones.
  kEnd,            ///< v = kPatternLength_m is where the strip ends at a junction.
  kZebra,          ///< Pedestrians have priority: bars.
  kCrossing,       ///< Pedestrians have a signal: two broken lines.
  kLevelCrossing,  ///< Of the rails' strip: where a road runs over it.
};

/// What drivers meet at the junction of kStart and kEnd.
enum class Control : std::uint8_t { kNone, kGiveWay, kStop, kSignals };

struct Pattern {
  map::SurfaceClass surface{};
  std::vector<map::Lane> lanes;  ///< Of one strip, left to right.
  Stretch stretch = Stretch::kAlong;
  Control control = Control::kNone;
  map::DrivingSide side = map::DrivingSide::kRight;
  bool has_kerb_left = true, has_kerb_right = true;  ///< In towns; where there is none, larger roads get edge lines.
  double gauge_m = kStandardGauge_m;                 ///< Of kRail lanes.
};

/// A total order, by all members; doubles by their bits' order.
std::strong_ordering operator<=>(const Pattern& a, const Pattern& b);
inline bool operator==(const Pattern& a, const Pattern& b) { return (a <=> b) == 0; }

double width_m(const Pattern& pattern);
/// u of each lane's left side, and last the strip's width: lanes.size() + 1 numbers.
std::vector<double> lane_sides_m(const Pattern& pattern);
/// How much of the pattern is used: kPatternLength_m, or kCrossingLength_m.
double length_m(const Pattern& pattern);

/// The same strip as seen against the way: (u, v) there is (width - u, length - v) here. Its own inverse.
Pattern turned_round(const Pattern& pattern);

/// The lesser of a pattern and itself turned round: two strips that only differ in which way their road was drawn share
/// its column.
struct CanonicalPattern {
  Pattern pattern;
  bool is_turned;  ///< Then the strip's (u, v) is (width - u, length - v) in the pattern.
};
CanonicalPattern canonical(const Pattern& pattern);

}  // namespace citykiln::roads
