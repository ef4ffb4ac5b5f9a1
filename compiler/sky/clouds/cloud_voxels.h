// Clouds as a grid of voxels, for programs that show volumes.
#pragma once

#include <array>
#include <vector>

#include "compiler/sky/clouds/clouds_over.h"

namespace citykiln::sky {

/// Edge of a block in voxels, as in OpenVDB's leaves.
inline constexpr int kVoxelBlock = 8;
/// A cube of kVoxelBlock³ voxels.
struct VoxelBlock {
  std::array<int, 3> low;         ///< Index of the block's first voxel, each a multiple of kVoxelBlock.
  std::vector<float> extinction;  ///< By voxel: extinction per metre. x is the slowest index, z the fastest.
};

/// A sparse grid of voxels. Voxel (i, j, k) is a cube of edge voxel_m about origin + (i, j, k) · voxel_m, in plane
/// metres.
struct CloudVoxels {
  double voxel_m = 1;
  Vec3 origin;
  std::vector<VoxelBlock> blocks;  ///< Sorted; blocks without cloud are left out.
};

/// Returns the extinction of all layers on one grid: the sum, over the layers, of the layer's extinction times the
/// share of the voxel that is inside of its clouds, approximately. Equal bytes on every CPU. Cost: O(particles times
/// their voxels).
/// @param layers   The result of clouds_over().
/// @param origin   The position of voxel (0, 0, 0), plane metres.
/// @param voxel_m  The edge of a voxel, plane metres, > 0.
CloudVoxels cloud_voxels(std::span<const LayerParticles> layers, Vec3 origin, double voxel_m);

}  // namespace citykiln::sky
