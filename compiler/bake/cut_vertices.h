// Vertices of meshes that are cut: new ones on edges, and the removal of those that no triangle has.
#pragma once

#include <cstdint>

#include "compiler/materials/material_mesh.h"

namespace citykiln::bake {

/// Adds a vertex on the edge between two vertices, at a share of it from the first: snapped to 2^-10 m, with linearly
/// interpolated normal, texture coordinates and tint.
void add_vertex_between(materials::MaterialMesh& mesh, std::uint32_t a, std::uint32_t b, double share);

/// Removes the vertices that no triangle has. The order of the others stays. O(vertices + triangles).
void drop_unused_vertices(materials::MaterialMesh& mesh);

}  // namespace citykiln::bake
