// Reads a way's tags into its cross-section.
//
// Precedence where tags disagree; each disagreement is diagnosed kBadTagValue once:
//   1. lanes:forward, lanes:backward, lanes:both_ways over lanes; lanes over the number of entries of …:lanes lists
//   2. bicycle:lanes, bus:lanes, psv:lanes over lanes:bus, lanes:psv, busway, cycleway
//   3. …:left and …:right over …:both over the key alone; parking:… over parking:lane:…
//   4. width:lanes over width over est_width over the class's widths (regional_widths.inc, track_rules.inc). A width
//      gives each lane that width:lanes does not state kNarrowestLane_m of lane_rules.inc at least, except a lane that
//      is alone on the carriageway. A width that would give each lane of lanes=* more than kWidestLane_m, even with a
//      row of parked cars on each side that has no lane beside the moving ones, is that of the whole street and ignored
//
// Defaults without tags:
//   - pavements, verges, shoulders, parking and cycle lanes exist only if tagged
//   - lanes=* counts driving, bus and turning lanes, neither cycle lanes nor parking
//   - the odd lane of a two-way road is driven both ways
//   - two lanes that no tag counts become one if two cars could not pass
//   - roundabouts and motorways are one-way
//   - width=* is kerb to kerb: it includes cycle lanes and cars parked on the carriageway, but not bays, shoulders,
//     verges, raised cycle tracks and pavements
//   - outside the kerb the verge comes first, then the cycle track, then the pavement
//
// Source: wiki.openstreetmap.org, Key:lanes, Lanes, Key:turn, Key:placement, Key:cycleway, Key:sidewalk,
// Street_parking, Key:parking:lane, Key:busway, Key:shoulder, Key:verge, Key:width.
#pragma once

#include "compiler/map/countries/road_guidelines.h"
#include "compiler/map/cross_section.h"
#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// The cross-section of a way, and which of its values are tagged.
struct TaggedSection {
  CrossSection section;
  bool has_width = false;             ///< True if width=*, est_width=* or width:lanes=* states the carriageway's width.
  bool has_placement = false;         ///< True if placement=* states the place of the axis.
  std::uint8_t tagged_pavements = 0;  ///< Sides on which tags say whether there is a pavement: bits of RoadSide.
  std::uint8_t tagged_verges = 0;     ///< Sides on which tags say whether there is a verge.
  std::uint8_t tagged_parking = 0;    ///< Sides on which tags say whether cars park.
  bool is_transition = false;         ///< True if placement=transition leaves it to the ways before and after.
};
/// Returns the cross-section of a way and its sources; default widths and numbers of lanes follow a set of guidelines.
///
/// Guarantees: where only class, lanes, oneway and width are tagged and agree, the lanes together have the width of
/// track_rules.inc. Swapping the driving side and left and right in all tags mirrors the lanes exactly. Reversing the
/// way and swapping forward and backward, left and right in all tags reverses them, up to 2^-10 m a lane. Raised lanes
/// do not move the axis. Unreadable values are diagnosed kBadTagValue and ignored; a way of unknown class is a path.
/// O(length of the tags).
TaggedSection tagged_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side,
                                RoadGuidelines guidelines = RoadGuidelines::kElsewhere);

}  // namespace citykiln::map
