// Points at even distances, decided by a hash alone: no order, no neighbour beyond the reach.
#pragma once

#include <functional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"

namespace citykiln::plants {

/// A point, and the number of its lattice cell for further draws.
struct Site {
  Vec2 at;  ///< Plane metres, snapped.
  StableId id;
  double height_m = 0;  ///< Of the ground there.
};

/// Whether a site may be at a place; where it may, sets how high the ground is there.
using Allowed = std::function<bool(Vec2 at, double& height_m)>;

struct Sites {
  std::vector<Site> accepted;  ///< In the half-open box, by lattice row, then column.
  std::size_t undecided = 0;   ///< Places in it whose turn did not come; no site.
};

/// Sites at even distances in the half-open box.
///
/// @param allowed  Asked for places in the box widened by reach_m only.
/// Guarantees: any two accepted sites are at least `spacing_m` apart from foot to foot, heights counted; whether a site
/// is accepted depends on nothing beyond reach_m. Method: a jittered candidate in each cell of a fixed lattice of the
/// plane; in each round a candidate with the highest priority among the undecided within spacing is accepted, and
/// rejects those about it in the next; what is undecided after the rounds that fit the reach (at most 12) is rejected.
/// Source: priority-based parallel Poisson disks, after Bowers, Wang, Wei, Maletz, "Parallel Poisson disk sampling with
/// spectrum analysis on surfaces", 2010.
Sites blue_noise(std::uint64_t seed, StableId owner, double spacing_m, const Box2& box, double reach_m,
                 const Allowed& allowed);

}  // namespace citykiln::plants
