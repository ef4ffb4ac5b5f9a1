#include "preview/adaptive_samples.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace citykiln::preview {
namespace {

constexpr int kMostPilot = 16, kLeastPilot = 2;

// Darker blocks are as good as black beside the rest of the picture.
constexpr double kDark = 0.02;

}  // namespace

SamplePlan plan_samples(int most, double noise) {
  const int pilot = std::min(most / 4, kMostPilot);
  return {noise > 0 && pilot >= kLeastPilot ? pilot : 0, std::max(most, 1)};
}

int further_samples(const SamplePlan& plan, const PilotBlock& block, double picture_luminance, double noise) {
  assert(plan.pilot > 0 && noise > 0);
  const int least = plan.pilot, most = plan.most - plan.pilot;
  const double weight = 1 - plan.pilot_weight();
  const double error = noise * std::max(block.luminance, kDark * picture_luminance);
  const double left = error * error - plan.pilot_weight() * plan.pilot_weight() * block.variance / plan.pilot;
  if (block.variance <= 0) return least;
  if (!(left > 0)) return most;
  const double count = weight * weight * block.variance / left;
  return count >= most ? most : std::max(least, static_cast<int>(std::ceil(count)));
}

}  // namespace citykiln::preview
