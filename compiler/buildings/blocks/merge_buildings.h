// Merges neighbouring buildings of similar height and with narrow gaps between them into blocks, which are prisms.
//
//    plan: footprints       gaps closed, outline      section:   _     _          ____
//    ▒▒▒ ▒▒  ▒▒▒            straightened                        | |_ | |   →     |    |
//    ▒▒▒ ▒▒▒ ▒▒▒      →     ▒▒▒▒▒▒▒▒▒▒▒                         | | || |         |    |
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/recipe.h"
#include "compiler/geometry/mesh.h"

namespace citykiln::buildings {

/// The role of a building in merging.
enum class BlockRole : std::uint8_t {
  kMerged,  ///< The building may be merged with neighbours. Small blocks are left out.
  kAlone,   ///< The building is a block of its own, which is never left out.
  kAbsent   ///< The building is in no block, and other buildings may take its area.
};

/// The share of the tolerance that each step of merging may use.
inline constexpr double kHeightShare = 0.25;    ///< The largest difference of heights in a block.
inline constexpr double kGapShare = 0.5;        ///< The longest edge of a triangle that closes a gap.
inline constexpr double kOutlineShare = 0.125;  ///< The largest movement of an outline.
/// Small blocks of kMerged buildings, which are left out: lower than kLowShare of the tolerance; or lower than s and
/// with an area below s², where s is kSmallShare of the tolerance.
inline constexpr double kLowShare = 0.0625, kSmallShare = 0.25;

/// A block of buildings, in plane metres, z up.
struct Block {
  std::vector<std::uint32_t> members;  ///< Indices of buildings, ascending, even if the block is left out.
  Mesh roof, walls;                    ///< Empty if the block is left out.
};

/// Returns blocks of buildings. Each building that is not kAbsent is a member of one block.
///
/// @param buildings    In plane metres. Indices in the result are indices into this list.
/// @param roles        One per building.
/// @param tolerance_m  > 0. Shares below are shares of it.
///
/// - Where footprints overlap, the highest building has the area. Two buildings are neighbours if they touch, or if a
///   triangle of their Delaunay triangulation with edges up to kGapShare closes the gap between them. Neighbours whose
///   heights are most alike are merged first.
/// - A roof lies above each vertex of its outline by the mean height of the block's buildings, weighted by area,
///   measured from the lower ends of the walls there. So roofs follow slopes.
/// - Walls reach from the roof down to the neighbouring roof, or to the lower ends of the buildings' walls.
///
/// Guarantees, before certified_blocks() measures: a point of a closed gap is within kGapShare / √3 of a footprint in
/// plan (the farthest place of a triangle from its corners is nearer than its longest edge / √3); outlines move by up
/// to kOutlineShare; at a vertex of a building its roof moves by up to kHeightShare. Walls and roofs of all blocks
/// together are closed but for their undersides. Same input, same bytes; all tests are exact. Cannot fail. Cost: O(n
/// log n) in vertices. Sources: Jones, Bundy, Ware, "Map generalization with a triangulated data structure", CaGIS 22,
/// 1995 (closing gaps by triangles); simplify_borders.h for outlines.
std::vector<Block> merge_buildings(std::span<const Building> buildings, std::span<const BlockRole> roles,
                                   double tolerance_m);

}  // namespace citykiln::buildings
