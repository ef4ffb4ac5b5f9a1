// Cross-sections: which lanes a way has from its left edge to its right one, read from its OSM tags.
//
//     s|pddp|s     letters    s pavement  p parking  c cycling  b bus  d driving  t turning from both directions
//     -|vv^^|-     directions S shoulder  / buffer   f foot     r rails  g verge
//                             ^ along the way, v against it, - both; | a kerb: what is outside it is raised
//
// Who wins when tags disagree (each disagreement is diagnosed kBadTagValue once):
//   1. lanes:forward, lanes:backward, lanes:both_ways over lanes; lanes over the number of entries of …:lanes lists
//   2. bicycle:lanes, bus:lanes, psv:lanes over lanes:bus, lanes:psv, busway, cycleway
//   3. …:left and …:right over …:both over the key alone; parking:… over parking:lane:…
//   4. width:lanes over width over est_width over the class's widths (track_rules.inc); never narrower than
//      kNarrowestLane_m of lane_rules.inc, but for a lane that is alone
//
// What the tags do not say: pavements, verges, shoulders, parking and cycle lanes are only there where tagged (an
// untagged residential street has no pavement). lanes=* counts driving, bus and turning lanes, neither cycling nor
// parking. The odd lane of a two-way road whose directions are not told is driven both ways. A road of two lanes that
// no tag counted is one lane where two cars would not pass. A roundabout and a motorway are one-way. width=* is kerb to
// kerb: cycle lanes and cars parked on the carriageway are inside it; bays, shoulders, verges, raised cycle tracks and
// pavements are beside it. Outside the kerb the verge comes first, then the cycle track, then the pavement.
//
// Source: wiki.openstreetmap.org, Key:lanes, Lanes, Key:turn, Key:placement, Key:cycleway, Key:sidewalk,
// Street_parking, Key:parking:lane, Key:busway, Key:shoulder, Key:verge, Key:width.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

struct ReadContext;

enum class LaneKind : std::uint8_t {
  kDriving,
  kBus,
  kTurn,      ///< In the middle, to turn from, of both directions.
  kCycle,     ///< A lane; a track where it is raised.
  kParking,   ///< On the carriageway, half on the kerb or in bays.
  kShoulder,  ///< Paved, beside the lanes.
  kBuffer,    ///< Painted or raised, between cyclists and cars.
  kSidewalk,  ///< A road's pavement. Always raised.
  kFoot,      ///< The whole of a footway, path, bridleway, pedestrian street or stairs.
  kRail,      ///< The whole of a track of rails.
  kVerge,     ///< A strip of grass. Always raised.
  kCount
};

enum class LaneDirection : std::uint8_t { kForward, kBackward, kBoth };  ///< As seen along the way's direction.

/// Bits of Lane::turns, as turn:lanes says them: seen by who drives. None set: nothing marked.
enum LaneTurn : std::uint16_t {
#define TURN(value, name, bit) name = 1 << (bit),
#define TURN_ALIAS(value, name)
#include "compiler/map/lanes/lane_rules.inc"
#undef TURN
#undef TURN_ALIAS
};

struct Lane {
  LaneKind kind{};
  LaneDirection way = LaneDirection::kBoth;
  double width_m = 0;       ///< > 0, a multiple of 2^-10.
  std::uint16_t turns = 0;  ///< LaneTurn bits.
  bool is_raised = false;   ///< Outside the kerb: pavements, cycle tracks, verges.
  bool operator==(const Lane&) const = default;
};

struct CrossSection {
  std::vector<Lane> lanes;   ///< Left to right, seen along the way. At least one is not raised, at most 42 in all.
  double axis_offset_m = 0;  ///< From the left edge of the carriageway (of the lanes that are not raised) to the way; a
                             ///< multiple of 2^-11.
  bool operator==(const CrossSection&) const = default;
};

enum class DrivingSide : std::uint8_t { kRight, kLeft };

/// The cross-section of the way with these tags.
///
/// Guarantees: where nothing but class, lanes, oneway and width is tagged, and they agree, the lanes are together as
/// wide as track_rules.inc says. With traffic on the other side and left and right swapped in all tags the lanes are
/// mirrored exactly; with the way turned round and forward, backward, left and right swapped in all tags they are
/// turned round, but for 2^-10 m a lane. What is beside the carriageway does not move the axis. Total: values that
/// cannot be read are diagnosed kBadTagValue and read as absent; a way of no known class is a path. O(length of the
/// tags).
CrossSection cross_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side);

/// All lanes that are not raised.
double carriageway_width_m(const CrossSection& section);
/// All lanes.
double total_width_m(const CrossSection& section);

/// "s|pddp|s -|vv^^|-", as the head of this file says.
std::string to_string(const CrossSection& section);

}  // namespace citykiln::map
