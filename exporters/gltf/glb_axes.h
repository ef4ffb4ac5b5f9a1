// Converts between the z-up frame of the plane and glTF's y-up frame. No other file does so.
#pragma once

#include "compiler/bake/baked_tile.h"

namespace citykiln::exporters {

/// Converts a position or direction: (x, y, z) of the plane is (x, z, -y) of glTF. Zeros stay positive, so a round trip
/// gives the same bits.
inline bake::Float3 to_gltf(const bake::Float3& v) { return {v[0], v[2], 0.0f - v[1]}; }
inline bake::Float3 from_gltf(const bake::Float3& v) { return {v[0], 0.0f - v[2], v[1]}; }
/// Converts a quaternion or a tangent: its first three components like a vector.
inline bake::Float4 to_gltf(const bake::Float4& q) { return {q[0], q[2], 0.0f - q[1], q[3]}; }
inline bake::Float4 from_gltf(const bake::Float4& q) { return {q[0], 0.0f - q[2], q[1], q[3]}; }

}  // namespace citykiln::exporters
