// Blocks with a certified error. A block is a prism that replaces neighbouring buildings of similar height. A block too
// far from its buildings is divided again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/blocks/merge_buildings.h"
#include "compiler/buildings/generate.h"
#include "compiler/simplify/triangle_tree.h"

namespace citykiln::buildings {

/// The buildings of which blocks are made, and the surfaces against which they are measured.
struct BlockSources {
  std::span<const Building> buildings;
  std::span<const GeneratedBuilding> shapes;  ///< One per building, generated with SceneContext::is_for_blocks.
  std::span<const simplify::Corners> ground;  ///< The ground of the level.
};

/// The blocks, and the buildings that are not replaced.
struct CertifiedBlocks {
  std::vector<Block> blocks;
  std::vector<std::uint32_t> kept;  ///< Indices of buildings that belong to no block, and are shown by their shapes.
  double error_m = 0;               ///< Certified error, at most the tolerance.
};

/// Returns the tolerance at which BlockSources::shapes are generated, for a tolerance of blocks.
double block_source_tolerance_m(double tolerance_m);

/// Returns blocks that stand for the buildings.
///
/// Guarantee: error_m bounds the Hausdorff distance: no visible point of a full building is farther from the blocks,
/// the kept shapes and the level's ground, and no point of a block is farther from a full building. Proof: let e be the
/// largest stated error of the shapes, which are within e of the full buildings, both ways. distance_bound_m() bounds
/// the distances of all shapes from blocks, kept shapes and ground, and of all blocks from shapes, by d. By the
/// triangle inequality error_m = d + e. Method: if the bound of a block exceeds the tolerance less e, its buildings
/// become blocks of their own; if the bound of such a block does, the building is kept. So the loop ends, and the bound
/// holds. Cost: merging and measuring, in a few rounds; 20 µs per triangle of a shape.
CertifiedBlocks certified_blocks(const BlockSources& sources, double tolerance_m);

}  // namespace citykiln::buildings
