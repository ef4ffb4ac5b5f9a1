// Writes the materials of a level as UsdPreviewSurface, with textures in separate files.
#pragma once

#include <string>

#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// Returns the path of a primitive's material, which write_materials() will write.
/// @param cutout  The result of shared_cutout() for an instanced mesh; else null.
std::string material_path(UsdBuilder& b, const bake::Primitive& p, const impostor::Cutout* cutout);

/// Returns the first cutout of the level that equals this one, and adds this one if there is none; null if it has no
/// texels.
const impostor::Cutout* shared_cutout(UsdBuilder& b, const impostor::Cutout& cutout);

/// Returns the image that a primitive's uvs refer to; null if there is none.
const materials::TextureImage* image_of(const UsdBuilder& b, const bake::Primitive& p, const impostor::Cutout* cutout);

/// Writes the scope "materials" with all materials whose paths were requested.
///
/// | material               | diffuseColor                                                                      |
/// |------------------------|-----------------------------------------------------------------------------------|
/// | of one colour          | displayColor, which has the tint of every vertex                                  |
/// | with an image          | the image times the mean tint of the mesh: no node of the preview surface         |
/// |                        | multiplies a texture with a primvar                                               |
///
/// Roughness, metalness, emission, opacity and normals are equal to the .glb's; v of `st` points up in the image.
void write_materials(UsdBuilder& b);

}  // namespace citykiln::exporters
