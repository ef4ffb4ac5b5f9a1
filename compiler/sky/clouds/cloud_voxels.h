// Clouds as a grid of voxels, for programs that show volumes.
#pragma once

#include <array>
#include <vector>

#include "compiler/sky/clouds/clouds_over.h"

namespace citykiln::sky {

/// Edge of a block in voxels, as in OpenVDB's leaves.
inline constexpr int kVoxelBlock = 8;
struct VoxelBlock {
  std::array<int, 3> low;         ///< Index of its first voxel, each a multiple of kVoxelBlock.
  std::vector<float> extinction;  ///< Extinction per metre of kVoxelBlock cubed voxels: x slowest, z fastest.
};

/// A sparse grid of voxels. Voxel (i, j, k) is a cube of edge voxel_m about origin + (i, j, k) · voxel_m, in plane
/// metres.
struct CloudVoxels {
  double voxel_m = 1;
  Vec3 origin;
  std::vector<VoxelBlock> blocks;  ///< Sorted; blocks without cloud are left out.
};

/// Returns the extinction of all layers on one grid: a layer's extinction times the share of the voxel that is inside
/// of it, approximately. Where layers overlap it is their sum. Equal bytes on every CPU. Cost: O(particles times their
/// voxels).
/// @param origin  Plane metres.
CloudVoxels cloud_voxels(std::span<const LayerParticles> layers, Vec3 origin, double voxel_m);

}  // namespace citykiln::sky
