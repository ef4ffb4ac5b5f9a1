// Inset facets: planar pieces of a plan whose value at each position is its distance inward from the eaves. Lifted by a
// section they are a roof.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/straight_skeleton.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// Returns the form at an end that faces `outward` (unit length).
using WingEndOf = std::function<End(Vec2 outward)>;

/// Facets whose planes give metres inward from the eaves, and the largest such value.
struct InsetFacets {
  std::vector<Facet> facets;
  double span_m = 0;
};

/// Returns the parts of a convex ring where each plane is the lowest. These are the straight skeleton of a convex
/// footprint, also with gables and half hips. Facet::face is the index of the plane. O(n² · corners).
InsetFacets envelope_facets(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// Returns the largest value within the ring of the lowest plane.
double span_over(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// Returns the faces of the straight skeleton of any simple polygon; empty if the skeleton fails. An end of a wing is
/// an edge whose face is a triangle between two nearly parallel walls. At a gable the faces beside the end are extended
/// over it; at a half hip only above half its height.
///
/// @param first_face  The number of the first face.
InsetFacets skeleton_facets(const Polygon& polygon, SkeletonKernel kernel, const WingEndOf& end_of,
                            std::uint32_t first_face);

/// Cuts the facets along the corners of the section and lifts them. The planes of the result are heights over the eaves
/// plane.
std::vector<Facet> lift_section(const InsetFacets& inset, const Section& section, double rise_m);

}  // namespace citykiln::roofs
