// Writes the clouds of a scene as meshes in a .glb (glTF 2.0, binary).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"
#include "compiler/sky/clouds/cloud_surface.h"

namespace citykiln::exporters {

/// The surfaces of a layer of clouds.
struct CloudMeshes {
  sky::CloudLayer layer;
  std::size_t clouds = 0;
  std::vector<sky::CloudSurface> parts;
};

/// Returns a .glb with the node "clouds", a child for each layer ("cumulus", "cirrus"), and a child of these for each
/// part. Positions are relative to the root's translation, whole metres near the middle of the parts; y is up.
///
/// - Surfaces are white and matt, lit by the viewer's light, not by their own. Thick layers are opaque. Thin ones
///   (sky::is_thin) have a vertex opacity in COLOR_0 and are blended: exp(-optical depth) of what is behind passes.
/// - extras of the root: cell_m, error_m (of the surface: a cell's diagonal times the largest stretch of a
///   layer's frame, so that it holds in plane metres), particle_m, and the plane; of layers: kind, cover, base_m,
///   top_m, clouds.
///
/// Guarantees: deterministic; Khronos' validator reports 0 errors and 0 warnings.
/// @param layers      At least one part in all.
/// @param cell_m      The cells of the surfaces, in the layers' frames.
/// @param particle_m  The smallest radius of particles.
/// @param frame       The name of the coordinates' frame, for the root's extras; empty: the scene's plane.
std::vector<std::byte> encode_clouds(std::span<const CloudMeshes> layers, const scene::Header& header, double cell_m,
                                     double particle_m, const std::string& frame = "");

}  // namespace citykiln::exporters
