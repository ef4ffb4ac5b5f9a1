// Points at even distances, decided by a hash alone: no order, no neighbour beyond the reach.
#pragma once

#include <functional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"

namespace citykiln::plants {

/// A point, and the number of its lattice cell for further draws.
struct Site {
  Vec2 at;
  StableId id;
  double slope = 1;  ///< Ground length per plan length, at least 1.
};

/// Where a site may be, and how steep it is there; nothing where not.
using Allowed = std::function<bool(Vec2 at, double& slope)>;

/// The accepted sites in the half-open box.
///
/// @param allowed  Asked for places in the box widened by reach_m only.
/// Guarantees: any two accepted sites are at least `spacing_m` apart on the ground (plan distance times the larger slope); whether a site is accepted depends on
/// nothing beyond reach_m. Method: a jittered candidate in each cell of a fixed lattice of the plane; in each round a candidate with the highest priority among
/// the undecided within spacing is accepted and rejects those about it; what is undecided after the rounds that fit the reach (at most 12) is rejected.
/// Source: priority-based parallel Poisson disks, after Bowers et al., "Parallel Poisson disk sampling with spectrum analysis on surfaces", 2010.
std::vector<Site> blue_noise(std::uint64_t seed, StableId owner, double spacing_m, const Box2& box, double reach_m, const Allowed& allowed);

}  // namespace citykiln::plants
