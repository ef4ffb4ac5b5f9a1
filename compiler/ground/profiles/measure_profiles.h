// Measures whether stored profiles keep their guarantees.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ground/profiles/plan_profiles.h"

namespace citykiln::ground {

/// Lengths and grades of all lines of one class.
struct GradeMeasure {
  map::LandCoverClass surface{};
  double length_m = 0;
  double over_m = 0;    ///< Length steeper than the class's limit by more than rounding.
  double steepest = 0;  ///< Largest rise over run, of runs of 2 m or more.
};

/// The measures of all profiles. A knot is a point of a profile, which is linear between knots.
struct ProfileMeasures {
  std::vector<GradeMeasure> classes;  ///< One for each class that occurs, sorted by class.
  double length_m = 0, over_m = 0;    ///< Sums over roads and rails, without paths.
  double largest_jump_m = 0;          ///< Largest difference of height between two ways at a common node.
  std::uint64_t knots = 0;
  std::uint64_t crossings = 0;   ///< Pairs of lines of which one passes over the other.
  std::uint64_t shortfalls = 0;  ///< Pairs with a shortfall above kShortfallMargin_m.
  double largest_shortfall_m = 0;
  std::uint64_t shortfalls_over_1_m = 0, shortfalls_over_3_m = 0;
  std::uint64_t contradictions = 0;  ///< Pairs with a shortfall and contradictory layers; not counted as shortfalls.
};

/// Measures all profiles of a map.
ProfileMeasures measure_profiles(const map::FeatureView& features, const Profiles& profiles);

}  // namespace citykiln::ground
