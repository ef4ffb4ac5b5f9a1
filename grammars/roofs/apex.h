// Roofs that rise to one point over a footprint that sees all of itself from there: pyramid, cone, dome, onion.
//
//        .^.          the footprint's outline, scaled towards its pole as a section says, ring over ring;
//       /|||\         an onion's rings swell before they shrink
//      ( ||| )
//
// Not by OpenSubdiv: a limit surface of a cage leaves its outline where the footprint has corners, and says no error in
// metres; scaled outlines meet the walls in the footprint's own edges, are flat between two rings, and their error is
// the section's.
#pragma once

#include <optional>
#include <span>

#include "grammars/roofs/roof.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// A point that sees all of the ring from within: its centroid if the ring is convex or sees it well, else the middle
/// of all such points; on the 2^-10 m grid. Nothing where there is none, or it is so close to an edge's line that the
/// roof would be steep there. O(n²).
std::optional<Vec2> apex_of(std::span<const Vec2> ring);

/// From the pole to the nearest edge's line: what an angle is measured over, metres.
double apex_span_m(std::span<const Vec2> ring, Vec2 apex);

/// From the pole to the farthest corner.
double apex_radius_m(std::span<const Vec2> ring, Vec2 apex);

/// @param section  By section_over_apex().
/// Guarantees: as Roof's; error_m is the section's. Points of a ring that come together near the top are one.
/// O(n · corners).
Roof roof_over_apex(std::span<const Vec2> ring, Vec2 apex, const Section& section, double rise_m);

}  // namespace citykiln::roofs
