// Roofs that rise to one apex from which the whole footprint is visible: pyramid, cone, dome, onion.
//
//        .^.          The rings of the roof are the outline of the footprint, scaled towards the apex by the section.
//       /|||\         The rings of an onion swell before they shrink.
//      ( ||| )
//
// Scaled outlines meet the walls along their edges, are planar between two rings, and have the error of the section.
#pragma once

#include <optional>
#include <span>

#include "grammars/roofs/roof.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// Returns a point inside of the ring from which the whole ring is visible, on the 2^-10 m grid: the centroid if the
/// ring is convex or the centroid is well inside of all edges' lines, else the centroid of the kernel (the set of all
/// such points). Returns std::nullopt if there is no such point, or if the point is so near to an edge's line that the
/// roof would be steep there. O(n²).
std::optional<Vec2> apex_of(std::span<const Vec2> ring);

/// Returns the distance from the apex to the nearest edge's line. The angle of a roof is measured over this distance.
double apex_span_m(std::span<const Vec2> ring, Vec2 apex);

/// Returns the distance from the apex to the farthest corner.
double apex_radius_m(std::span<const Vec2> ring, Vec2 apex);

/// Returns the roof whose rings are `ring`, scaled towards the apex by x of the section and lifted by y.
/// @param section  A result of section_over_apex().
/// Guarantees: the guarantees of Roof (roof.h); error_m is equal to the section's. Merges points of a ring that nearly
/// coincide near the apex. O(n · corners).
Roof roof_over_apex(std::span<const Vec2> ring, Vec2 apex, const Section& section, double rise_m);

}  // namespace citykiln::roofs
