// Writes the images of a .glb: marking atlas, facade atlas, textures, cutouts.
#pragma once

#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// Collects the cutouts of the tile, equal ones once. Call before primitives are added.
void find_cutouts(GlbBuilder& f);
/// The collected cutout that equals this one; null where it has no texels.
const impostor::Cutout* cutout_like(const GlbBuilder& f, const impostor::Cutout& cutout);

/// The texture index of an image. Images without texels are not written and have none.
/// @param picture  The address of an image of the tile or of a collected cutout.
std::size_t picture_number(const GlbBuilder& f, const materials::TextureImage* picture);

/// Appends all images in the formats of f.pictures(), with samplers: the marking atlas, the facade atlas, colours and
/// normals of each texture, then of each cutout.
void add_pictures(GlbBuilder& f);

}  // namespace citykiln::exporters
