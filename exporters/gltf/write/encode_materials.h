// Writes the materials of a .glb.
#pragma once

#include "exporters/gltf/write/glb_builder.h"

namespace citykiln::exporters {

/// Returns the key of a primitive's material.
/// @param cutout  The result of cutout_like() for an instanced mesh; else null.
MaterialKey material_key_of(const GlbBuilder& f, const bake::Primitive& p, const impostor::Cutout* cutout);

/// Returns the index of the material with this key. Adds it at the first call.
std::size_t material_number(GlbBuilder& f, const MaterialKey& key);

/// Returns the normal map of a material; null if it has none.
const materials::TextureImage* normals_of(const GlbBuilder& f, const MaterialKey& key);

/// Adds TEXCOORD_0 and returns its accessor. Its unit is the image's size, or metres in packed meshes.
std::size_t add_uvs(GlbBuilder& f, const bake::Primitive& p, const MaterialKey& key);

}  // namespace citykiln::exporters
