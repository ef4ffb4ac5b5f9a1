// Blue noise: evenly spaced random samples. They depend only on hashes and the density nearby, so any part of the plane
// can be computed on its own. Distances are measured on the ground, not in plan.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/box.h"
#include "compiler/plants/recipe.h"

namespace citykiln::plants {

/// The density of samples at a position.
struct SampleDensity {
  double spacing_m = 0;     ///< The least distance on the ground to the next sample, up to kWidest_m; 0: no samples.
  double share = 1;         ///< The share of the samples that are kept, for densities below one per kWidest_m.
  double height_m = 0;      ///< The height of the ground, plane metres.
  double normal_z = 1;      ///< The z component of the ground's unit normal.
  std::uint32_t owner = 0;  ///< A number of the caller's, copied to samples.
};

/// A position that was chosen.
struct Sample {
  Vec2 at;  ///< Plane metres, snapped.
  StableId id;
  SampleDensity density;
};

/// The largest spacing. Lower densities keep a share of the samples.
inline constexpr double kWidest_m = 7.75;

/// The number of rounds in which candidates are accepted or rejected. Candidates that remain undecided are dropped.
inline constexpr int kRounds = 6;

/// The influence radius: whether a candidate becomes a sample depends on densities up to this distance.
inline constexpr double kSampleInfluence_m = kRounds * kWidest_m;

/// Ground with a smaller normal_z, steeper than 60°, has no samples.
inline constexpr double kLeastNormal_z = 0.5;

/// Returns the spacing and share that give a number of trees per hectare of ground, within 3 % on slopes up to 45°.
///
/// @param trees_per_ha  Clamped to kLeastTreesPerHa … kMostTreesPerHa.
SampleDensity density_for(double trees_per_ha);

/// Returns a lower bound of the spacings in a block, which is a square of 16 by 16 cells of the lattice; 0 if the block
/// has no samples, so that it is skipped. Plane metres.
using LeastSpacing = std::function<double(const Box2& block)>;
/// Returns the density at a position in plane metres. Called for positions in the box widened by kSampleInfluence_m.
using DensityAt = std::function<SampleDensity(Vec2 at)>;

/// Returns the samples in the half-open box (plane metres), by rows of a lattice.
///
/// Guarantees: two samples are at least the mean of their spacings apart in space; a sample depends only on densities
/// within kSampleInfluence_m. Method: each cell of a fixed lattice has a jittered candidate; a hash keeps as many as
/// give an equal number per spacing² of ground everywhere. In each round a candidate is accepted if its priority is the
/// highest among the undecided candidates within its spacing; in the next round it rejects these.
/// Cost: O(cells of blocks with samples + candidates · neighbours).
/// Source: priority-based parallel Poisson disks, after Bowers, Wang, Wei, Maletz, "Parallel Poisson disk sampling with
/// spectrum analysis on surfaces", 2010.
std::vector<Sample> blue_noise(std::uint64_t seed, const Box2& box, const LeastSpacing& least_spacing,
                               const DensityAt& density_at);

}  // namespace citykiln::plants
