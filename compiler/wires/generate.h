// Generates the wires of a span.
#pragma once

#include <vector>

#include "compiler/materials/material_mesh.h"
#include "compiler/wires/recipe.h"

namespace citykiln::wires {

/// The meshes of a span, and their distance from the span in full detail.
struct GeneratedWires {
  std::vector<materials::MaterialMesh> meshes;
  double error_m = 0;
};

/// Generates a span. A wire is a closed prism of three sides along its parabola, which is cut into straight pieces of
/// equal length in plan: n pieces lie above it, by at most sag_m / n². From the tolerance on at which all wires are
/// near enough to the one in their middle, this one stands for them. A span that is no higher above the ground than the
/// tolerance has no mesh, and its height is the error.
///
/// Guarantees: error_m <= tolerance_m; vertices are on the 2^-10 m grid; the same bytes on every CPU. O(pieces).
/// @param tolerance_m  > 0.
GeneratedWires generate(const WireSpan& span, double tolerance_m);

/// Returns the number of equal pieces of a parabola with this sag that stay within a distance of it: the smallest one.
int pieces_of(double sag_m, double distance_m);

}  // namespace citykiln::wires
