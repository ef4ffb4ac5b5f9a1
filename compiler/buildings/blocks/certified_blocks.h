// Blocks with a certified error: those that stray too far are taken apart again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/buildings/blocks/merge_buildings.h"
#include "compiler/buildings/generate.h"
#include "compiler/simplify/triangle_tree.h"

namespace citykiln::buildings {

/// What blocks are made from and measured against.
struct BlockSources {
  std::span<const Building> buildings;
  std::span<const GeneratedBuilding> shapes;  ///< One per building, for SceneContext::is_for_blocks.
  std::span<const simplify::Corners> ground;  ///< The ground of the same level.
};

struct CertifiedBlocks {
  std::vector<Block> blocks;
  std::vector<std::uint32_t> kept;  ///< Buildings that are no members of blocks: their shapes stay.
  double error_m = 0;               ///< At most the tolerance.
};

/// The tolerance of the shapes that blocks are made from.
double block_source_tolerance_m(double tolerance_m);

/// Returns blocks that stand for the buildings.
///
/// Guarantee: error_m is a Hausdorff distance, both ways: no visible place of a full building is farther from the
/// blocks, the kept shapes and the level's ground, and no place of a block from a full building. Proof: let e be the
/// largest stated error of the shapes, which are within e of the full buildings, both ways. The distances of all shapes
/// from blocks, kept shapes and ground, and of all blocks from shapes, are bounded by distance_bound_m(), by d. By the
/// triangle inequality error_m = d + e. Method: where the bound of a block is more than the tolerance leaves, its
/// buildings become blocks of their own, and where that is too far, they are kept. So the loop ends, with a bound that
/// holds. Cost: merging and measuring, for each of up to some rounds; 20 µs a triangle of a shape.
CertifiedBlocks certified_blocks(const BlockSources& sources, double tolerance_m);

}  // namespace citykiln::buildings
