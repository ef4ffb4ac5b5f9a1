// Areas that are bridges, and the bridges of the map that they carry.
//
//        path ───┤▓▓▓▓▓▓▓├─── path      an area with bridge=yes: an axis joins the nodes where ways meet its outline
//     road ══════╪▓▓▓▓▓▓▓╪══════ road   man_made=bridge: the bridges that run on it are its axes
#pragma once

#include <vector>

#include "compiler/map/tags/read_context.h"

namespace citykiln::map {

/// True for a surface that is a bridge (not a mere outline).
bool is_bridge_area(const ReadContext& context, const source::Area& area);

/// Reads areas that are bridges: surfaces of area_rules.inc with bridge=yes that stand, and outlines of bridges
/// (man_made=bridge). Water is left out. Their tracks are empty. Ledger "map/bridge area".
std::vector<BridgeArea> locate_bridge_areas(const ReadContext& context);

/// Returns the share of an axis, sampled each metre, that lies in a polygon.
double share_inside(const Polyline& axis, const Polygon& polygon);

/// The least share of a bridge's length on an area for its road to need no deck of its own.
inline constexpr double kCarriedShare = 0.85;

/// Tracks, and the areas that carry some of them.
struct CarriedTracks {
  std::vector<Track> tracks;
  std::vector<BridgeArea> areas;  ///< Areas that carry at least one track, sorted by id.
};

/// Decides which bridges each area carries: those that lie on it for a third of their length, or run over half of it.
/// An area without such gets axes of its own, which are bridges of the class of the ways that meet its outline at map
/// nodes: from one such node to the farthest other one, and from every other one to the nearest place on it; the widest
/// way across the area where fewer than two ways meet it. Ids of axes are the area's, with parts from kFirstDerivedPart
/// on. An area with bridge=yes that lies in an outline belongs to it. An outline without bridges that ways on the
/// ground run through is left out (kBridgeOutlineOnGround), and so is one too short for an axis
/// (kBridgeAreaWithoutDeck). Bridges of another layer count only where none of the area's layer lies on it. O(n log n)
/// in tracks and O(areas · tracks near).
CarriedTracks with_bridge_areas(std::vector<Track> tracks, std::vector<BridgeArea> areas, Report& report);

}  // namespace citykiln::map
