#include "compiler/sky/clouds/cloud_voxels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

namespace citykiln::sky {
namespace {

constexpr std::size_t kInBlock = kVoxelBlock * kVoxelBlock * kVoxelBlock;

// Distances to the union, in the layer's frame, of a block's voxels.
using Distances = std::array<float, kInBlock>;
using Blocks = std::map<std::array<int, 3>, Distances>;

struct Grid {
  Vec3 origin;
  double voxel_m;
  Vec3 place(std::array<int, 3> i) const { return origin + Vec3{i[0] * voxel_m, i[1] * voxel_m, i[2] * voxel_m}; }
  std::array<int, 3> index(Vec3 p) const {
    const auto of = [&](double m) { return static_cast<int>(std::floor(m / voxel_m)); };
    return {of(p.x - origin.x), of(p.y - origin.y), of(p.z - origin.z)};
  }
};

// The least number of plane metres per metre of the frame, over all directions.
double shortest(const LayerFrame& frame) { return std::min({frame.stretch, frame.flatten, 1.0}); }

void add_to_block(Distances& distances, const Grid& grid, std::array<int, 3> low, const LayerFrame& frame,
                  const CloudParticle& sphere) {
  std::size_t at = 0;
  for (int x = 0; x < kVoxelBlock; ++x)
    for (int y = 0; y < kVoxelBlock; ++y)
      for (int z = 0; z < kVoxelBlock; ++z, ++at) {
        const Vec3 own = frame.into(grid.place({low[0] + x, low[1] + y, low[2] + z}));
        const double d = std::max(length(own - sphere.centre) - sphere.radius_m, -own.z);
        distances[at] = std::min(distances[at], static_cast<float>(d));
      }
}

int block_of(int voxel) { return voxel >= 0 ? voxel / kVoxelBlock : -((kVoxelBlock - 1 - voxel) / kVoxelBlock); }

void add_sphere_to_blocks(Blocks& blocks, const Grid& grid, const LayerFrame& frame, const CloudParticle& sphere) {
  const auto [low_corner, high_corner] = box_of(sphere, frame);
  const Vec3 edge = {grid.voxel_m, grid.voxel_m, grid.voxel_m};
  const auto first = grid.index(low_corner - edge), last = grid.index(high_corner + edge);
  Distances far;
  far.fill(1e9f);
  for (int x = block_of(first[0]); x <= block_of(last[0]); ++x)
    for (int y = block_of(first[1]); y <= block_of(last[1]); ++y)
      for (int z = block_of(first[2]); z <= block_of(last[2]); ++z) {
        const std::array low = {x * kVoxelBlock, y * kVoxelBlock, z * kVoxelBlock};
        add_to_block(blocks.try_emplace(low, far).first->second, grid, low, frame, sphere);
      }
}

void add_layer(const LayerParticles& layer, const Grid& grid, std::map<std::array<int, 3>, std::vector<float>>& sums) {
  Blocks blocks;
  for (const CloudParticle& sphere : layer.spheres) add_sphere_to_blocks(blocks, grid, layer.frame, sphere);
  // density falls from 1 to 0 over one voxel, in the direction in which the frame is scaled least
  const double soft_m = grid.voxel_m / shortest(layer.frame);
  const double extinction = extinction_per_m(layer.layer.kind);
  for (const auto& [low, distances] : blocks) {
    std::vector<float>& sum = sums.try_emplace(low, kInBlock, 0.0f).first->second;
    for (std::size_t i = 0; i < kInBlock; ++i)
      sum[i] += static_cast<float>(extinction * std::clamp(0.5 - distances[i] / soft_m, 0.0, 1.0));
  }
}

}  // namespace

CloudVoxels cloud_voxels(std::span<const LayerParticles> layers, Vec3 origin, double voxel_m) {
  assert(voxel_m > 0);
  std::map<std::array<int, 3>, std::vector<float>> sums;
  for (const LayerParticles& layer : layers) add_layer(layer, {origin, voxel_m}, sums);
  CloudVoxels voxels{.voxel_m = voxel_m, .origin = origin, .blocks = {}};
  for (auto& [low, extinction] : sums)
    if (std::ranges::any_of(extinction, [](float e) { return e > 0; }))
      voxels.blocks.push_back({low, std::move(extinction)});
  return voxels;
}

}  // namespace citykiln::sky
