// Bases: how far inward each place of a plan is, in flat pieces. A section laid over a base is a roof.
//
//   envelope: the lowest of some planes; what a convex footprint's straight skeleton is, and any gable or half a hip on
//   it hips:     the straight skeleton of any other footprint, with gables where its wings end
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "compiler/geometry/polygon.h"
#include "compiler/geometry/straight_skeleton.h"
#include "grammars/roofs/facet.h"
#include "grammars/roofs/section.h"

namespace citykiln::roofs {

/// What becomes of an edge where a wing ends.
enum class End : std::uint8_t { kHip, kHalfHip, kGable };

/// What stands at an end that looks `outward` (unit length).
using WingEndOf = std::function<End(Vec2 outward)>;

/// Facets whose planes are metres inward from the eaves, and the largest of them.
struct InsetFacets {
  std::vector<Facet> facets;
  double span_m = 0;
};

/// Where each plane is the lowest, within a convex ring. Facets keep the planes' order as `face`. O(n² · corners).
InsetFacets envelope_facets(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// Largest height of an envelope within the ring.
double span_over(std::span<const Vec2> convex_ring, std::span<const Plane> planes);

/// The faces of the straight skeleton. An end is an edge whose face is a triangle between two walls that run nearly
/// parallel: there its neighbours' faces grow together over it, up to a gable, or half way up.
///
/// Nothing where the skeleton fails. `first_face` numbers the faces.
InsetFacets skeleton_facets(const Polygon& polygon, SkeletonKernel kernel, const WingEndOf& end_of,
                            std::uint32_t first_face);

/// Cuts a base along the section's corners and lifts it: heights over the eaves plane.
std::vector<Facet> lifted(const InsetFacets& base, const Section& section, double rise_m);

}  // namespace citykiln::roofs
