// Inset facets: planar pieces of a plan whose value at each position is its distance inward from the eaves. A section
// (the height as a function of that distance) lifts them to a roof.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/polygons/straight_skeleton.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// A function that returns the form of a wing's end which faces `outward` (unit length).
using WingEndOf = std::function<WingEnd(Vec2 outward)>;

/// Facets whose planes give the distance inward from the eaves in metres, and the largest such distance.
struct InsetFacets {
  std::vector<Facet> facets;
  double span_m = 0;
};

/// Returns the parts of a convex ring in which each plane is the lowest: the faces of the straight skeleton, also with
/// gables and half hips. Facet::face is the index of the plane. O(n² · corners).
/// @param planes  For each edge of the footprint, the distance inward from it.
InsetFacets envelope_facets(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// Returns the largest value, over the ring, of the minimum of all planes.
double span_over(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// Returns the faces of the straight skeleton of any simple polygon; empty if the skeleton fails. An end of a wing is
/// an edge whose face is a triangle between two nearly parallel walls. At a gable the faces beside the end are extended
/// over it; at a half hip only above half its height.
///
/// @param first_face   The number of the first Facet::face; the others follow.
InsetFacets skeleton_facets(const Polygon& polygon, SkeletonKernel kernel, const WingEndOf& end_of,
                            std::uint32_t first_face);

/// Cuts the facets along the corners of the section and lifts them. The planes of the returned facets give heights over
/// the eaves plane.
/// @param rise_m  The height of the top of the section, over the eaves plane.
std::vector<Facet> lift_section(const InsetFacets& inset, const Section& section, double rise_m);

}  // namespace citykiln::roofs
