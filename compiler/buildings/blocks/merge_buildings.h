// Blocks: prisms of neighbouring buildings, merged where their heights are alike and the gaps between them narrow.
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

/// How a building takes part.
enum class BlockRole : std::uint8_t {
  kMerged,  ///< It may be merged with neighbours, and left out where its block is small.
  kAlone,   ///< It is a block of its own.
  kAbsent   ///< Its area is free.
};

/// The shares of the tolerance that each step of merging may use.
inline constexpr double kHeightShare = 0.25;    ///< Heights of a block's buildings differ by at most this.
inline constexpr double kGapShare = 0.5;        ///< Longest edge of a triangle that closes a gap.
inline constexpr double kOutlineShare = 0.125;  ///< How far outlines may move.
/// Blocks that are lower than the first, or lower than the second and smaller than its square, are left out.
inline constexpr double kLowShare = 0.0625, kSmallShare = 0.25;

struct Block {
  std::vector<std::uint32_t> members;  ///< Ascending. Those of a block that is left out, too.
  Mesh roof, walls;                    ///< Empty where the block is left out.
};

/// Returns blocks of buildings; each building that is not absent is a member of one.
///
/// - Where footprints overlap, the highest building has the area. Buildings that touch, and those across a gap that a
///   triangle of their Delaunay triangulation with edges up to kGapShare closes, are neighbours. Neighbours whose
///   heights are most alike are merged first.
/// - A roof lies above each vertex of its outline by the mean height of the block's buildings, weighted by area,
///   measured from the lower ends of the walls there. So roofs follow slopes.
/// - Walls reach from the roof down to the neighbouring roof, or to the lower ends of the buildings' walls.
///
/// Guarantees, before certified_blocks() measures: a point of a closed gap is within kGapShare / √3 of a footprint in
/// plan (the farthest place of a triangle from its corners is nearer than its longest edge / √3); outlines move by up
/// to kOutlineShare; at a vertex of a building its roof moves by up to kHeightShare. Walls and roofs of all blocks
/// together are closed but for their undersides. Same input, same bytes; all tests are exact. Cost: O(n log n) in
/// vertices. Sources: Jones, Bundy, Ware, "Map generalization with a triangulated data structure", CaGIS 22, 1995
/// (closing gaps by triangles); simplify_borders.h for outlines.
///
/// @param roles  One per building.
std::vector<Block> merge_buildings(std::span<const Building> buildings, std::span<const BlockRole> roles,
                                   double tolerance_m);

}  // namespace citykiln::buildings
