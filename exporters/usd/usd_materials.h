// Writes the materials of a level: UsdPreviewSurface, with textures in files of their own.
#pragma once

#include <string>

#include "exporters/usd/usd_builder.h"

namespace citykiln::exporters {

/// The path of the material of a primitive, which is written when write_materials() is called.
/// @param cutout  As shared_cutout() returns it for an instanced mesh; else null.
std::string material_path(UsdBuilder& b, const bake::Primitive& p, const impostor::Cutout* cutout);

/// The cutout of the level that equals this one, which is added when it is new; null where it has no texels.
const impostor::Cutout* shared_cutout(UsdBuilder& b, const impostor::Cutout& cutout);

/// The image that a primitive's uvs lie on; null where they show none.
const materials::TextureImage* image_of(const UsdBuilder& b, const bake::Primitive& p, const impostor::Cutout* cutout);

/// Writes the scope "materials" with all materials that were asked for.
///
/// | material               | diffuseColor                                                                      |
/// |------------------------|-----------------------------------------------------------------------------------|
/// | of one colour          | displayColor, which has the tint of every vertex                                  |
/// | with an image          | the image times the mean tint of the mesh: no node of the preview surface         |
/// |                        | multiplies a texture with a primvar                                               |
///
/// Roughness, metalness, emission, opacity and normals are those of the .glb; v of `st` points up in the image.
void write_materials(UsdBuilder& b);

}  // namespace citykiln::exporters
