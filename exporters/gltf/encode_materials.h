// Writes the materials of a .glb.
#pragma once

#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// The key of a primitive's material.
/// @param cutout  As cutout_like() returns it for an instanced mesh; else null.
MaterialKey material_key_of(const GlbBuilder& f, const bake::Primitive& p, const impostor::Cutout* cutout);

/// The index of the material with this key, which is added when it is first asked for.
std::size_t material_number(GlbBuilder& f, const MaterialKey& key);

/// The normal map of a material; null where it has none.
const materials::TextureImage* normals_of(const GlbBuilder& f, const MaterialKey& key);

/// Adds TEXCOORD_0 and returns its accessor: in units of the image's size, or metres in packed meshes.
std::size_t add_uvs(GlbBuilder& f, const bake::Primitive& p, const MaterialKey& key);

}  // namespace citykiln::exporters
