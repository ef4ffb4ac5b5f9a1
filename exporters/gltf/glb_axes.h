// The only place where the z-up frame of the plane becomes glTF's y-up frame, and back.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// (x, y, z) of the plane is (x, z, -y) of glTF. Zeros stay positive, so that a round trip gives the same bits.
inline bake::Float3 to_gltf(const bake::Float3& v) { return {v[0], v[2], 0.0f - v[1]}; }
inline bake::Float3 from_gltf(const bake::Float3& v) { return {v[0], 0.0f - v[2], v[1]}; }
/// Vector parts of quaternions, and tangents, are transformed like vectors.
inline bake::Float4 to_gltf(const bake::Float4& q) { return {q[0], q[2], 0.0f - q[1], q[3]}; }
inline bake::Float4 from_gltf(const bake::Float4& q) { return {q[0], 0.0f - q[2], q[1], q[3]}; }

}  // namespace citykiln::exporters
