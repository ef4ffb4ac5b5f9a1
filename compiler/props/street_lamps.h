// Street lamps in plan: where they stand that nobody mapped, along streets that are told to be lit, and which way those
// face that somebody did.
//
//     ___o_________________o___    a lamp half a spacing from the way's start, then one every spacing
//     =======|=====|=====|=====>   the way; its carriageway is wide: lamps stand on either side in turn
//     ______________o__________    feet behind the kerbs, arms square to the way and over the carriageway
//
// Source: EN 13201-2 asks for light on the road by its class, not for distances; what is built to meet it stands 3 to 5
// times its mounting height apart, on one side of a road that is no wider than about that height, else staggered.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/geometry/box.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/props/recipe.h"
#include "compiler/roads/recipe.h"

namespace citykiln::props {

enum class LampKind : std::uint8_t {
  kPostTop,  ///< A lantern on a post: paths and quiet streets.
  kArm,      ///< A head that an arm holds over the road.
  kCount
};

/// How streets of a class are lit.
struct Lighting {
  double spacing_m = 0;  ///< 0: not by street lamps (rails, runways).
  double height_m = 0;
  LampKind kind{};
};
Lighting lighting_of(map::LandCoverClass surface);

/// A lamp that stands somewhere.
struct StreetLamp {
  Vec2 at;      ///< Its foot, plane metres, snapped.
  Vec2 facing;  ///< Where its arm points, length 1.
  double height_m = 0;
  LampKind kind{};
  OsmId feature;  ///< The lamp as mapped, or the way it lights.
  bool operator==(const StreetLamp&) const = default;
};

/// The lamps of a lit road that stand in the box (its lower sides included, its upper ones not), whatever else is
/// there. None where the road is not lit.
///
/// On carriageways wider than 9 m they alternate; else they stand on the side that has a pavement, where both or none
/// have on that of the traffic. 0.5 m behind the kerb and any raised cycle track, or in the middle of a narrower
/// pavement; where there is none, 0.75 m beyond the edge.
///
/// Guarantees: runs that a way was trimmed to have together the lamps of the way, to the bit; boxes that share no
/// points share no lamps. Total. O(points + lamps in the box).
std::vector<StreetLamp> lamps_along(const roads::Road& road, const Box2& box);

/// The lamps along all lit roads that find a place in the box: not on a carriageway, parked cars, rails, water, steps,
/// a track or cycle path, nor in a building; not within one spacing of a mapped lamp, which tells that the street's
/// lamps are mapped; and along a path not where a lit street lights it. In the order of the roads.
///
/// @param mapped    Where lamps are mapped.
/// @param surfaces  Must cover the box.
/// Total. O(segments + lamps * (roads + mapped)).
std::vector<StreetLamp> lamps_of_streets(std::span<const roads::Road> roads, std::span<const Lamp> mapped,
                                         const ground::LandCoverIndex& surfaces, const Box2& box);

/// Mapped lamps as they stand: each faces the nearest place on the axis of a street within 12 m, where there is none of
/// a path, where there is none +x; of equally near ones that of the first road. That road says the kind, and the height
/// where none is told; without one it is a post 6 m high. Total. O(segments + lamps * roads).
std::vector<StreetLamp> mapped_lamps(std::span<const Lamp> lamps, std::span<const roads::Road> roads);

}  // namespace citykiln::props
