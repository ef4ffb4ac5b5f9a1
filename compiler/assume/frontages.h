// Paves streets up to the walls where houses stand close to the kerb in a closed row, as in the middle of towns, and
// lays strips up to footways beside the kerb on other sides (footway_strips.h).
//
//     [#####][##][#######]  [#####]     1. a side is closed if many samples see a wall of a town house within
//     .....................................   kFrontage_m of the kerb, and few see no house within kOpenFrontage_m
//     pavement                          2. its pavement becomes as wide as an upper quantile of the distances from
//     ===============================>     kerb to wall; width limits (roads/width_limits) narrow it at each wall
//     .....................................  3. ways without pavements, such as pedestrian streets, and footways and
//     [####][#####][####][####][#####]     service roads between walls, become as wide themselves
#pragma once

#include <span>
#include <vector>

#include "compiler/assume/beside.h"
#include "compiler/assume/room.h"
#include "compiler/contract/findings/report.h"
#include "compiler/map/features.h"

namespace citykiln::assume {

/// The largest distance from kerb to wall of a closed frontage, and the distance from which a side is open.
inline constexpr double kFrontage_m = kWidestStrip_m, kOpenFrontage_m = 12;
/// Walls this near to the kerb have no garden before them, whatever the house.
inline constexpr double kNoGarden_m = 2.5;
/// The widest strips beside footways, and beside streets without kerbs, that are paved.
inline constexpr double kBesideLane_m = 3;

/// The walls along one side of a stretch, from samples about every 8 m. Shares are from 0 to 1.
struct Frontage {
  double closed = 0;  ///< The share that sees a wall within kFrontage_m of the kerb: of a town house, or near the kerb.
  double open = 0;    ///< The share that sees no house within kOpenFrontage_m of the kerb.
  double town = 0;    ///< The share that sees a town house within kOpenFrontage_m of the kerb.
  double wall_m = 0;  ///< An upper quantile of the distance from kerb to wall over the closed samples; 0 without any.
};

/// True if two fifths of the samples or more are closed, and at most two fifths open.
bool is_closed(const Frontage& frontage);

struct BothFrontages {
  Frontage left, right;
};

/// Returns the walls along both sides of a stretch. A barrier or a car park before a wall hides it.
/// O(length · lines near it).
BothFrontages frontages_beside(const Surroundings& surroundings, const map::Track& stretch);

/// Returns the tracks, sorted by id, with pavements and lanes that reach the walls of closed frontages. A pavement is
/// at most kFrontage_m wide; it stops at other ways, water and areas that are mapped more finely than land use, and may
/// cover footways that are mapped beside the street. A side does not change if tags state its pavement's width, or that
/// it has none, or if a tagged verge lies outside of the pavement. Assumed verges on closed sides are left out. Sides
/// that are not closed get the strips of footway_strips.h.
///
/// Track::closed_sides has the closed sides with a pavement, also where its width is tagged or already reaches the
/// walls, and the sides of carriageways and footways that become wider. A carriageway or footway changes only if no tag
/// states its width. Pedestrian streets of more than kLongestWhole_m (pavements.h) become several tracks. Runs after
/// all other assumptions about tracks; the radius is kPavementRadius_m (pavements.h). O(n log n), n: points of all
/// features.
/// @param mapped  The tracks before pavements were assumed.
std::vector<map::Track> assume_frontages(const map::FeatureView& features, std::span<const map::Track> mapped,
                                         Report& report);

}  // namespace citykiln::assume
