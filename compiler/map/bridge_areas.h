// Areas that are bridges, and the bridges of the map that they carry.
//
//        path ───┤▓▓▓▓▓▓▓├─── path      an area with bridge=yes: an axis joins the nodes where ways meet its outline
//     road ══════╪▓▓▓▓▓▓▓╪══════ road   man_made=bridge: the bridges that run on it are its axes
#pragma once

#include <vector>

#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// True for an area with bridge=yes and a row of area_rules.inc that may be the top of a bridge: neither water, nor a
/// wood, nor without a class. False for outlines of bridges (man_made=bridge without that).
bool is_bridge_area(const ReadContext& context, const source::Area& area);

/// Returns the areas that are bridges and touch the extent, one per polygon, with BridgeArea::tracks empty. They are
/// surfaces, for which is_bridge_area() is true, and outlines (man_made=bridge). Water, woods and areas without a class
/// count only as outlines. Areas that are gone (lifecycle.inc) are left out. Ledger "map/bridge area". O(areas).
std::vector<BridgeArea> locate_bridge_areas(const ReadContext& context);

/// Returns the share of an axis that lies in a polygon, 0 to 1, by samples at most 1 m apart; 0 for an axis without
/// length. O(metres · corners).
double share_inside(const Polyline& axis, const Polygon& polygon);

/// The least share_inside() an area of a bridge's axis from which its road needs no deck of its own.
inline constexpr double kCarriedShare = 0.85;

/// The tracks of a map with the axes of its bridge areas, and these areas.
struct CarriedTracks {
  std::vector<Track> tracks;      ///< The given ones in their order, then the axes of areas.
  std::vector<BridgeArea> areas;  ///< Areas that carry at least one track, sorted by id, with BridgeArea::tracks set.
};

/// Decides which bridges each area carries, and gives areas the axes that they lack.
///
/// 1. A surface joins an outline in which more than half of its corners lie. The outline takes the class of the largest
///    such surface, and, if it has no layer, that of a surface.
/// 2. Areas, by id, take the bridges that no area before them has. A bridge is carried if a third of its length lies on
///    the area, or a length of half the longer side of the area's box. Bridges of another layer count only if none of
///    the area's layer does; layer 0 agrees with every layer.
/// 3. Joins are the map nodes at which other ways than tunnels meet the outline: at their ends, or at their only node
///    on it. An area that carries bridges gets a paved foot path of 2 m width from each join to the nearest node of
///    these bridges.
/// 4. An area that carries none gets a main axis between the two joins that are farthest apart, as wide as the area is
///    on average, within 2 to 60 m, and an axis of 2 m width from every other join straight to it. With one join, the
///    main axis ends at the corner of the outline that is farthest from it; with none, it joins the two corners that
///    are farthest apart. The class is that of the road with the highest priority among the ways that meet the area,
///    else a paved foot path.
///
/// Axes are bridges (Passage::kBridge). Their ids are the area's, with parts from kFirstDerivedPart on
/// (contract/derived_id.h); the node ids of their new vertices are far below those of maps.
///
/// Left out: an outline without bridges through which a way on the ground runs for 60 % of its length
/// (kBridgeOutlineOnGround), and any area whose main axis would be shorter than 2 m (kBridgeAreaWithoutDeck).
///
/// The order of the areas does not matter. O(n log n) in tracks; quadratic in areas, since each outline is compared
/// with all areas, and in the corners and joins of an area.
CarriedTracks with_bridge_areas(std::vector<Track> tracks, std::vector<BridgeArea> areas, Report& report);

}  // namespace citykiln::map
