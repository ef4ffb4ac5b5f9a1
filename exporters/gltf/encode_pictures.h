// Pictures into a .glb: the sheet, the atlas, textures, cutouts.
#pragma once

#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// What of the tile's cutouts are alike is written once: before any primitive is.
void find_cutouts(GlbBuilder& f);
/// The one that is written for it, if any.
const impostor::Cutout* cutout_like(const GlbBuilder& f, const impostor::Cutout& cutout);

/// The number of a picture among all: the sheet, the atlas, each texture's colours and normals, then cutouts'. Those
/// without texels are none.
int picture_number(const GlbBuilder& f, const materials::TextureImage* picture);

/// Appends them all, in that order, as PNG, with samplers.
void add_pictures(GlbBuilder& f);

}  // namespace citykiln::exporters
