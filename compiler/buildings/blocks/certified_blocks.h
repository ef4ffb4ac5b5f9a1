// Blocks with a bounded error, for coarse levels of detail. A block is a prism that replaces neighbouring buildings of
// similar height. A block too far from its buildings is divided again.
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
  std::span<const Building> buildings;  ///< Recipes: plain data from which buildings are generated.
  /// One per building, generated at block_source_tolerance_m() with SceneContext::is_for_blocks: low buildings have
  /// meshes too, and no face has a baked image.
  std::span<const GeneratedBuilding> shapes;
  std::span<const simplify::Corners> ground;  ///< The triangles of the ground at the blocks' tolerance.
};

/// The blocks, and the buildings that are not replaced.
struct CertifiedBlocks {
  std::vector<Block> blocks;        ///< The prisms.
  std::vector<std::uint32_t> kept;  ///< Indices of buildings that belong to no block, and are shown by their shapes.
  double error_m = 0;               ///< The proven bound of the error, at most the tolerance.
};

/// Returns the tolerance at which BlockSources::shapes are generated, for a tolerance of blocks.
double block_source_tolerance_m(double tolerance_m);

/// Returns blocks that stand for the buildings.
///
/// Guarantee: error_m bounds the Hausdorff distance. A full building is one generated at tolerance 0. Every visible
/// point of a full building is within error_m of the blocks, the kept shapes or the ground. Every point of a block is
/// within error_m of a full building.
///
/// Proof: let e be the largest stated error of the shapes, which are within e of the full buildings, both ways.
/// distance_bound_m() bounds by d the distances of all shapes from blocks, kept shapes and ground, and of all blocks
/// from shapes. By the triangle inequality error_m = d + e.
///
/// Method: if the bound of a block exceeds tolerance_m - e, each of its buildings becomes a block of its own. If the
/// bound of a block of one building exceeds tolerance_m - e, that building is kept. A building changes at most twice,
/// so the loop terminates.
///
/// Cost: merging and measuring, in a few rounds; 20 µs per triangle of a shape.
CertifiedBlocks certified_blocks(const BlockSources& sources, double tolerance_m);

}  // namespace citykiln::buildings
