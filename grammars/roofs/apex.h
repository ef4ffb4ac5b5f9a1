// Roofs that rise to one apex from which the whole footprint is visible: pyramid, cone, dome, onion.
//
//        .^.          The rings of the roof are the outline of the footprint, scaled towards the apex by the section.
//       /|||\         The rings of an onion swell before they shrink.
//      ( ||| )
//
// OpenSubdiv is not used: a limit surface leaves the footprint at its corners and has no error bound in metres. Scaled
// outlines meet the walls along their edges, are planar between two rings, and have the error of the section.
#pragma once

#include <optional>
#include <span>

#include "grammars/roofs/roof.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// A point inside of the ring from which all of it is visible: the centroid if the ring is convex or the centroid is
/// well inside of all edges' lines, else the centroid of the kernel; on the 2^-10 m grid. std::nullopt if there is
/// none, or it is so near to an edge's line that the roof would be steep there. O(n²).
std::optional<Vec2> apex_of(std::span<const Vec2> ring);

/// The distance from the apex to the nearest edge's line, over which an angle is measured.
double apex_span_m(std::span<const Vec2> ring, Vec2 apex);

/// The distance from the apex to the farthest corner.
double apex_radius_m(std::span<const Vec2> ring, Vec2 apex);

/// @param section  As made by section_over_apex().
/// Guarantees: those of Roof; error_m is that of the section. Points of a ring that nearly coincide near the apex are
/// merged. O(n · corners).
Roof roof_over_apex(std::span<const Vec2> ring, Vec2 apex, const Section& section, double rise_m);

}  // namespace citykiln::roofs
