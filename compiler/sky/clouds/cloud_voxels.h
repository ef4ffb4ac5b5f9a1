// Clouds as a grid of voxels, for programs that show volumes.
#pragma once

#include <array>
#include <vector>

#include "compiler/sky/clouds/clouds_over.h"

namespace citykiln::sky {

/// Eight voxels cubed, as OpenVDB's leaves.
inline constexpr int kVoxelBlock = 8;
struct VoxelBlock {
  std::array<int, 3> low;         ///< Of its first voxel, a multiple of kVoxelBlock.
  std::vector<float> extinction;  ///< Per metre, of kVoxelBlock cubed voxels: x slowest, z fastest.
};

/// Voxel (i, j, k) is a cube of edge voxel_m around (i, j, k) voxel_m from `origin`, in the plane.
struct CloudVoxels {
  double voxel_m = 1;
  Vec3 origin;
  std::vector<VoxelBlock> blocks;  ///< Sorted; those with cloud alone.
};

/// Returns the extinction of all layers on one grid: that of a layer times the share of the voxel that is within,
/// about; where layers overlap, their sum.
/// @param origin  Plane metres. Same bytes on every CPU. Cost: O(particles times their voxels).
CloudVoxels cloud_voxels(std::span<const LayerParticles> layers, Vec3 origin, double voxel_m);

}  // namespace citykiln::sky
