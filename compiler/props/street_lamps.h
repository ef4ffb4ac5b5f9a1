// Street lamps in plan: derived along lit streets, and the direction of mapped ones.
//
//     ___o_________________o___    the first lamp half a spacing from the way's start, then one every spacing
//     =======|=====|=====|=====>   the way; along wide carriageways lamps alternate between the sides
//     ______________o__________    feet behind the kerbs, arms square to the way, over the carriageway
//
// Source: EN 13201-2 requires illuminance by road class. Lamps built to meet it stand 3 to 5 times their mounting
// height apart, on one side of roads up to about that width, otherwise staggered.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/luminaire.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

/// How roads of a class are lit.
struct Lighting {
  double spacing_m = 0;  ///< 0: no street lamps (rails, runways).
  double height_m = 0;
  LampKind kind{};
};
Lighting lighting_of(map::LandCoverClass surface);

/// A lamp with its position.
struct StreetLamp {
  Vec2 at;      ///< Its foot, plane metres, snapped.
  Vec2 facing;  ///< Direction of its arm, length 1.
  double height_m = 0;
  LampKind kind{};
  OsmId feature;  ///< The mapped lamp, or the way it lights.
  Luminaire light{};
  bool operator==(const StreetLamp&) const = default;
};

/// Returns the lamps of a road that stand in a box (lower sides inclusive, upper sides exclusive), whatever else is
/// there. None if the road is not lit.
///
/// On carriageways wider than 9 m they alternate between the sides; otherwise they stand on the side with a pavement,
/// or if both or neither have one on the side of traffic. Their distance from the kerb and any raised cycle track is
/// 0.5 m, or half of a narrower pavement; without pavement they stand 0.75 m beyond the edge.
///
/// Guarantees: the stretches of a trimmed way have the lamps of the whole way, bit for bit; disjoint boxes share no
/// lamps. Total. O(points + lamps in the box).
std::vector<StreetLamp> lamps_along(const roads::Road& road, const Box2& box);

/// Returns the lamps along all lit roads that have room in a box: not on carriageways, parking lanes, rails, water,
/// steps, tracks or cycle paths, nor in buildings; not within one spacing of a mapped lamp, where the street's lamps
/// are assumed to be mapped; and along paths not beside a lit street. In the order of the roads.
///
/// @param mapped  Mapped lamps.
/// @param index   Land cover of the box.
/// Total. O(segments + lamps * (roads + mapped)).
std::vector<StreetLamp> lamps_of_streets(std::span<const roads::Road> roads, std::span<const Lamp> mapped,
                                         const ground::LandCoverIndex& index, const Box2& box);

/// Returns mapped lamps with their direction, kind and height: each faces the nearest point on the axis of a street
/// within 12 m, else of a path, else +x; among equally near roads that of the first one. That road determines the kind
/// and the height if they are not tagged; without a road it is a post of 6 m. Its light is that of its tags, else of
/// kind and height (luminaire.h). Total. O(segments + lamps * roads).
std::vector<StreetLamp> mapped_lamps(std::span<const Lamp> lamps, std::span<const roads::Road> roads);

}  // namespace citykiln::props
