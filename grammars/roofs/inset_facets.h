// Inset facets: planar pieces that give the distance inward from the eaves at each position of a plan. A section drawn
// over them is a roof.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/straight_skeleton.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// The form at an end that faces `outward` (unit length).
using WingEndOf = std::function<End(Vec2 outward)>;

/// Facets whose planes give metres inward from the eaves, and the largest of these.
struct InsetFacets {
  std::vector<Facet> facets;
  double span_m = 0;
};

/// The parts of a convex ring where each plane is the lowest: the straight skeleton of a convex footprint, also with
/// gables and half hips. Facets have the order of the planes as `face`. O(n² · corners).
InsetFacets envelope_facets(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// The largest height of an envelope within the ring.
double span_over(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// The faces of the straight skeleton of any simple polygon. An end is an edge whose face is a triangle between two
/// nearly parallel walls. For a gable the faces beside it are extended over it, for a half hip half way up.
///
/// @param first_face  The number of the first face.
/// Empty if the skeleton fails.
InsetFacets skeleton_facets(const Polygon& polygon, SkeletonKernel kernel, const WingEndOf& end_of,
                            std::uint32_t first_face);

/// Cuts the facets along the corners of the section and lifts them: heights over the eaves plane.
std::vector<Facet> lift_section(const InsetFacets& inset, const Section& section, double rise_m);

}  // namespace citykiln::roofs
