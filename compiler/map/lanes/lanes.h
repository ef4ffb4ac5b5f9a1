// Reads a way's tags into its cross-section.
//
// Precedence where tags disagree; each disagreement is diagnosed kBadTagValue once:
//   1. lanes:forward, lanes:backward, lanes:both_ways over lanes; lanes over the number of entries of …:lanes lists
//   2. bicycle:lanes, bus:lanes, psv:lanes over lanes:bus, lanes:psv, busway, cycleway
//   3. …:left and …:right over …:both over the key alone; parking:… over parking:lane:…
//   4. width:lanes over width over est_width over the class's widths (regional_widths.inc, track_rules.inc)
//
// The width of the carriageway, width=* or est_width=*:
//   - lanes that width:lanes does not state share what is left of the width evenly
//   - a width that leaves them less than kNarrowestLane_m each (lane_rules.inc) is too small: it is diagnosed, and each
//     of them is that wide. A lane that is alone on the carriageway has the stated width, however narrow
//   - a width that leaves the lanes of lanes=* more than kWidestLane_m each is too large: it is diagnosed and ignored,
//     as some imports state the width of the whole street. Lanes for cycles and parked cars that count in the width are
//     subtracted before, and 2.5 m for parked cars on each side without a level lane beside the moving ones
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
  std::uint8_t fixed_pavements = 0;   ///< Sides on which tags state a pavement's width, or that there is none.
  std::uint8_t tagged_verges = 0;     ///< Sides on which tags say whether there is a verge.
  std::uint8_t tagged_parking = 0;    ///< Sides on which tags say whether cars park.
  bool is_transition = false;         ///< True if placement=transition leaves it to the ways before and after.
};
/// Returns the cross-section of a way, and which of its values are tagged.
///
/// @param tags        The tags of the way.
/// @param side        The side on which traffic drives.
/// @param guidelines  The source of widths and numbers of lanes that no tag states.
///
/// Guarantees: where only class, lanes, oneway and width are tagged and agree, the lanes together have the width of
/// track_rules.inc. Swapping the driving side and left and right in all tags mirrors the lanes exactly. Reversing the
/// way and swapping forward and backward, left and right in all tags reverses them, up to 2^-10 m a lane. Raised lanes
/// do not move the axis. Unreadable values are diagnosed kBadTagValue and ignored; a way of unknown class is a path.
/// O(length of the tags).
TaggedSection tagged_section_of(const ReadContext& context, OsmId id, source::Range tags, DrivingSide side,
                                RoadGuidelines guidelines = RoadGuidelines::kElsewhere);

}  // namespace citykiln::map
