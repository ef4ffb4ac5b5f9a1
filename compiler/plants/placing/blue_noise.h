// Points at even distances, decided by a hash alone: no order, no neighbour beyond the reach. Measured on the ground,
// not in projection.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// What may stand at a place.
struct SampleDensity {
  double spacing_m = 0;  ///< To the next, on the ground; 0: nothing may stand there. At most kWidest_m.
  double share = 1;      ///< Of the sites that are kept, so that fewer than one a spacing can be asked for.
  double height_m = 0;   ///< Of the ground.
  double normal_z = 1;   ///< The vertical part of the ground's unit normal.
  std::uint32_t owner = 0;
};

struct Sample {
  Vec2 at;  ///< Plane metres, snapped.
  StableId id;
  SampleDensity density;
};

/// Sites need no more than this between them; those who want fewer take a share.
inline constexpr double kWidest_m = 7.75;

/// In each candidates are accepted and reject their neighbours: what stays undecided after them is empty.
inline constexpr int kRounds = 6;

/// Whether a site is accepted depends on nothing farther off.
inline constexpr double kSampleInfluence_m = kRounds * kWidest_m;

/// Ground steeper than 60 degrees has no sites.
inline constexpr double kLeastNormal_z = 0.5;

/// The spacing and share that give so many sites a hectare of ground, on any slope up to 45 degrees, within 3 %, from
/// kLeastTreesPerHa to kMostTreesPerHa.
SampleDensity density_for(double trees_per_ha);

/// The least spacing of any seat that a block may hold; 0 where it holds none. Too small is allowed, too large is not.
using LeastSpacing = std::function<double(const Box2& block)>;
/// The seat at a place, asked for places in the box widened by kSampleInfluence_m only.
using DensityAt = std::function<SampleDensity(Vec2 at)>;

/// Sites at even distances in the half-open box, by rows of a lattice.
///
/// Guarantees: two accepted sites are at least the mean of their spacings apart from foot to foot, heights counted;
/// whether one is accepted depends on seats within kSampleInfluence_m alone. Method: a fixed lattice of the plane has a
/// jittered candidate in each cell; as many are kept, by hash, as make the same number a spacing's square of ground
/// everywhere; in each round a candidate with the highest priority among the undecided within spacing is accepted, and
/// rejects those about it in the next. Cost: O(cells of blocks with seats + candidates · neighbours).
/// Source: priority-based parallel Poisson disks, after Bowers, Wang, Wei, Maletz, "Parallel Poisson disk sampling with
/// spectrum analysis on surfaces", 2010.
std::vector<Sample> blue_noise(std::uint64_t seed, const Box2& box, const LeastSpacing& least_spacing,
                               const DensityAt& density_at);

}  // namespace citykiln::plants
