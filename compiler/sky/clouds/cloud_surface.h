// Meshes of clouds, for programs that show no volumes. The input are the particles of layers: spheres of droplets whose
// union is the clouds, in a frame of the layer that is scaled along the wind and upwards (LayerFrame).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/sky/clouds/clouds_over.h"

namespace citykiln::sky {

/// A part of the surface of a layer's clouds, in plane metres; z above sea level.
struct CloudSurface {
  std::vector<Vec3> positions, normals;  ///< One for each vertex; normals have unit length and point outwards.
  std::vector<double> opacity;           ///< Opacity of the whole cloud above and below each vertex, 0 to 1.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
};

/// Returns the surface of the union of a layer's particles, in parts of kSurfaceBlock by kSurfaceBlock cells in plan.
/// Neighbouring parts have equal vertices where they meet. Parts without triangles are left out.
///
/// Method: surface nets (Gibson, "Constrained Elastic Surface Nets", MICCAI 1998). The signed distance to the union is
/// computed at the nodes of a lattice. Each cell that the surface crosses gets a vertex, at the mean of its crossings
/// with the cell's edges.
/// @param cell_m  Edge of a cell in the layer's frame, > 0. The surface is within a cell's diagonal of the particles.
/// Guarantees: closed, except that it may miss particles much smaller than a cell. Equal bytes for any number of
/// threads and on every CPU. Cost: O(nodes near particles); memory: a block for each thread, and the surface.
std::vector<CloudSurface> cloud_surfaces(const LayerParticles& particles, double cell_m, int threads);

/// The side of a part of a surface, in cells.
inline constexpr int kSurfaceBlock = 64;

/// Layers with a smaller vertical optical depth are thin: their surfaces are transparent. Other layers have opaque
/// surfaces.
inline constexpr double kThinCloud = 3;
/// True if the layer's vertical optical depth is less than kThinCloud.
bool is_thin(const CloudLayer& layer);

}  // namespace citykiln::sky
