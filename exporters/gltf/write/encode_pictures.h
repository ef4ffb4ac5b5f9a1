// Writes the images of a .glb: marking atlas, facade atlas, textures, cutouts.
#pragma once

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// Collects the distinct cutouts of the tile. Call it before primitives are added.
void find_cutouts(GlbBuilder& f);
/// Returns the collected cutout that equals this one; null if this one has no texels.
const impostor::Cutout* cutout_like(const GlbBuilder& f, const impostor::Cutout& cutout);

/// Returns the texture index of an image, which must have texels: images without any are not written.
/// @param picture  The address of an image of the tile or of a collected cutout.
std::size_t picture_number(const GlbBuilder& f, const materials::TextureImage* picture);

/// Appends all images with their samplers, in the formats of f.pictures(): the marking atlas, the facade atlas, colours
/// and normals of each texture, colours and normals of each cutout.
void add_pictures(GlbBuilder& f);

}  // namespace citykiln::exporters
