// Pictures into a .glb: the sheet, the atlas, textures, cutouts.
#pragma once

#include "exporters/gltf/glb_filling.h"

namespace citykiln::exporters {

/// What of the tile's cutouts are alike is written once: before any primitive is.
void find_cutouts(Filling& f);
/// The one that is written for it, if any.
const imprint::Cutout* cutout_like(const Filling& f, const imprint::Cutout& cutout);

/// The number of a picture among all: the sheet, the atlas, each texture's colours and normals, then cutouts'. Those
/// without texels are none.
int picture_number(const Filling& f, const materials::Sheet* picture);

/// Appends them all, in that order, as PNG, with samplers.
void add_pictures(Filling& f);

}  // namespace citykiln::exporters
