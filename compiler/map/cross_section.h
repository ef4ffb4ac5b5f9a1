// Cross-sections: the lanes of a way from its left edge to its right edge.
//
//     s|pddp|s     letters    s pavement  p parking  c cycling  b bus  d driving  t turning from both directions
//     -|vv^^|-     directions S shoulder  / buffer   f foot     r rails  g verge
//                             ^ along the way, v against it, - both; | a kerb: lanes outside it are raised
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace citykiln::map {

/// The use of a lane.
enum class LaneKind : std::uint8_t {
  kDriving,
  kBus,
  kTurn,      ///< In the middle, for turning from both directions.
  kCycle,     ///< A cycle lane; if raised, a cycle track.
  kParking,   ///< On the carriageway, half on the kerb or in bays.
  kShoulder,  ///< A paved strip beside the lanes.
  kBuffer,    ///< A painted or raised strip between cyclists and cars.
  kSidewalk,  ///< A road's pavement. Always raised.
  kFoot,      ///< The whole of a footway, path, bridleway, pedestrian street or stairs.
  kRail,      ///< The whole of a track of rails.
  kVerge,     ///< A strip of grass. Always raised.
  kCount
};

enum class LaneDirection : std::uint8_t { kForward, kBackward, kBoth };  ///< Relative to the direction of the way.

/// Bits of Lane::turns: turns as drivers see them (turn:lanes). No bit: no arrows.
enum LaneTurn : std::uint16_t {
#define TURN(value, name, bit) name = 1 << (bit),
#define TURN_ALIAS(value, name)
#include "compiler/map/lane_turns.inc"
#undef TURN
#undef TURN_ALIAS
};

/// One lane of a way.
struct Lane {
  LaneKind kind{};
  LaneDirection way = LaneDirection::kBoth;
  double width_m = 0;       ///< > 0, a multiple of 2^-10.
  std::uint16_t turns = 0;  ///< LaneTurn bits.
  bool is_raised = false;   ///< True outside the kerb: pavements, cycle tracks, verges.
  bool operator==(const Lane&) const = default;
};

/// The lanes of a way.
struct CrossSection {
  std::vector<Lane> lanes;   ///< Left to right, seen along the way. At least one is not raised, at most 42 in all.
  double axis_offset_m = 0;  ///< Distance of the way from the left edge of the carriageway (the lanes that are not
                             ///< raised); a multiple of 2^-11. Where axis_drift is not 0: at the way's first point.
  double axis_drift = 0;     ///< Growth of axis_offset_m per metre along the whole way (placement=transition): a
                             ///< multiple of 2^-16, at most kMostDrift either way. The axis stays in the carriageway.
  bool operator==(const CrossSection&) const = default;
};

/// The width that a pavement keeps between buildings while the carriageway can narrow: a kerb stone and a foot beside
/// it. Its width elsewhere is tagged, or kSidewalk_m of map/lanes/lane_rules.inc.
inline constexpr double kMinPavement_m = 0.5;

/// The greatest slope of an axis within its carriageway.
inline constexpr double kMostDrift = 0.5;

/// Bits: the sides of a road, seen along the way.
enum RoadSide : std::uint8_t { kLeftSide = 1, kRightSide = 2, kBothSides = 3 };

/// The side of the road on which traffic drives.
enum class DrivingSide : std::uint8_t { kRight, kLeft };

/// True for lanes that narrow first: parking, shoulders and buffers.
bool is_soft(LaneKind kind);

/// The width of all lanes that are not raised.
double carriageway_width_m(const CrossSection& section);
/// The width of all lanes.
double total_width_m(const CrossSection& section);

/// Returns the distances from the axis to the left and the right kerb, where axis_drift is not 0 at the way's first
/// point. Parking lanes lie between the kerbs.
double left_kerb_m(const CrossSection& section);
double right_kerb_m(const CrossSection& section);

/// Returns the outermost lane between the kerbs on one side.
const Lane& lane_at_kerb(const CrossSection& section, bool is_left);

/// True if the traffic beside a kerb drives against the direction of the way: that of the lane there, or, where a lane
/// has both directions, that of the side on which one drives.
bool flows_back(const CrossSection& section, DrivingSide side, bool is_left);

/// Returns a road's pavement.
/// @param width_m  > 0; rounded to 2^-10 m.
Lane pavement_lane(double width_m);
/// Returns the section with a pavement as the outermost lane of each of these sides (bits of RoadSide).
/// @param width_m  > 0; rounded to 2^-10 m.
CrossSection with_pavement(CrossSection section, std::uint8_t sides, double width_m);

/// Returns the section with a verge beside the kerb on each of these sides, inside of pavements and cycle tracks.
/// @param width_m  > 0; rounded to 2^-10 m.
CrossSection with_verge(CrossSection section, std::uint8_t sides, double width_m);

/// Returns the section as "s|pddp|s -|vv^^|-", in the notation above.
std::string to_string(const CrossSection& section);

}  // namespace citykiln::map
