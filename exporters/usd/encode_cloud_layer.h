// Writes the clouds of a scene as a USD layer, as points and as a volume.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/sky/clouds/clouds_over.h"
#include "exporters/usd/layer_writer.h"

namespace citykiln::exporters {

/// Returns the layer of clouds: a crate in plane metres, z up.
///
///     /clouds             an Xform
///       cumulus, …        an Xform for each layer of clouds: the frame in which its particles are spheres
///         particles       Points, a point for each particle, with widths; purpose "proxy"
///       volume            a Volume with the field "density" of clouds.vdb; purpose "render"
///         density         OpenVDBAsset
///
/// Programs that draw volumes show the volume in renders and the points in viewports. Points overlap, and do not show
/// the flat bases of clouds, which the volume has.
/// @param has_volume  True if clouds.vdb is written beside the layer.
std::vector<std::byte> encode_cloud_layer(std::span<const sky::LayerParticles> layers, bool has_volume);

}  // namespace citykiln::exporters
