// Street lamps in plan: lamps along lit streets, and the direction of mapped lamps.
//
//     ___o_________________o___    the first lamp half a spacing from the way's start, then one every spacing
//     =======|=====|=====|=====>   the way; along wide carriageways lamps alternate between the sides
//     ______________o__________    feet behind the kerbs, arms square to the way, over the carriageway
//
// Source: EN 13201-2 requires illuminance by road class. Lamps built to meet it stand 3 to 5 times their mounting
// height apart, on one side of a road up to about as wide as that height, else alternating.
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

/// The lamps of a class of roads.
struct Lighting {
  double spacing_m = 0;  ///< 0: no street lamps (rails, runways).
  double height_m = 0;
  LampKind kind{};
};
/// Returns the lamps of the roads of a class.
Lighting lighting_of(map::LandCoverClass surface);
/// The largest Lighting::height_m.
inline constexpr double kTallestStreetLamp_m = 12;

/// A lamp with its position.
struct StreetLamp {
  Vec2 at{};      ///< Its foot, plane metres, snapped.
  Vec2 facing{};  ///< Direction of its arm, length 1.
  double height_m = 0;
  LampKind kind{};
  OsmId feature{};  ///< The mapped lamp, or the way it lights.
  Luminaire light{};
  bool operator==(const StreetLamp&) const = default;
};

/// Returns the lamps of a road that stand in a box (lower sides inclusive, upper sides exclusive). Other objects at
/// these places are not tested. Empty if the road is not lit.
///
/// On carriageways wider than 9 m they alternate between the sides. Otherwise they stand on the side with raised lanes
/// (pavement, cycle track or verge), or, if both or neither have some, on the side of traffic. They stand 0.5 m behind
/// the kerb and any raised cycle track, or in the middle of a pavement or verge narrower than 1 m; without pavement and
/// verge 0.75 m beyond the edge.
///
/// Guarantees: the parts of a trimmed way have the lamps of the whole way, bit for bit; disjoint boxes share no lamps.
/// O(points + lamps in the box).
std::vector<StreetLamp> lamps_along(const roads::Road& road, const Box2& box);

/// Returns the lamps along all lit roads that stand in a box, in the order of the roads, except
/// - lamps on carriageways, parking lanes, rails, water, steps, tracks or cycle paths, or in buildings;
/// - lamps within one spacing of a mapped lamp, as all lamps of such a street are assumed to be mapped;
/// - lamps of paths beside a lit street.
///
/// @param mapped  Mapped lamps.
/// @param index   Land cover of the box.
/// O(segments + lamps * (roads + mapped)).
std::vector<StreetLamp> lamps_of_streets(std::span<const roads::Road> roads, std::span<const Lamp> mapped,
                                         const ground::LandCoverIndex& index, const Box2& box);

/// Returns mapped lamps with their direction, kind and height. A lamp faces the nearest point on the axis of a street
/// within 12 m, else of a path within 12 m, else +x; on a tie the first road counts. Kind and height follow from the
/// tags, else from that road; without a road the lamp is a post top of 6 m. Its light follows from luminaire_of().
/// O(segments + lamps * roads).
std::vector<StreetLamp> mapped_lamps(std::span<const Lamp> lamps, std::span<const roads::Road> roads);

}  // namespace citykiln::props
