// Writes the materials of a .glb, and the uvs that show their images.
#pragma once

#include "exporters/gltf/glb_builder.h"

namespace citykiln::exporters {

/// The key of a primitive's material.
/// @param cutout  As cutout_like() returns it for an instanced mesh; else null.
MaterialKey material_key_of(const GlbBuilder& f, const bake::Primitive& p, const impostor::Cutout* cutout);

/// The index of the material with this key, which is added when it is first asked for.
int material_number(GlbBuilder& f, const MaterialKey& key);

/// The normal map of a material; null where it has none.
const materials::TextureImage* normals_of(const GlbBuilder& f, const MaterialKey& key);

/// Adds TEXCOORD_0 and returns its accessor: metres, or 16 bits where the uvs can be quantised.
int add_uvs(GlbBuilder& f, const bake::Primitive& p, const MaterialKey& key);

}  // namespace citykiln::exporters
