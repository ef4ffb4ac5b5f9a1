#include "preview/clouds/cloud_dome.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "compiler/contract/system/for_each_slot.h"
#include "preview/turn.h"

namespace citykiln::preview {
namespace {

// Cells around and up, of equal solid angle, and rays along each side of a cell.
constexpr int kAround = 96, kUp = 32, kRays = 2;

Vec3 direction_in(double column, double row) {
  const double z = row / kUp;
  return at_height(on_circle(column / kAround) * std::sqrt(std::max(0.0, 1 - z * z)), z);
}

// The mean of a cell's rays.
CloudVeil cell_of(const CloudField& field, const sky::SkyModel& model, Vec3 eye, int column, int row) {
  CloudVeil mean{.passed = 0, .added = {}};
  constexpr double kShare = 1.0 / (kRays * kRays);
  for (int i = 0; i < kRays * kRays; ++i) {
    const Vec3 along = direction_in(column + (i % kRays + 0.5) / kRays, row + (i / kRays + 0.5) / kRays);
    const CloudPath path = field.along(eye, along, std::numeric_limits<double>::infinity());
    const CloudVeil veil = path.passed < 1 ? veil_of(path, sky::air(model, along, path.distance_m)) : CloudVeil{};
    mean.passed += veil.passed * kShare;
    mean.added = mean.added + veil.added * kShare;
  }
  return mean;
}

}  // namespace

// The sky's radiance includes the light that air scatters before the clouds. `passed` removes a share of it, which is
// added again.
CloudVeil veil_of(const CloudPath& path, const sky::AirPath& before) {
  return {path.passed, before.added * (1 - path.passed) + before.passed * path.added};
}

CloudDome::CloudDome(const CloudField& field, const sky::SkyModel& model, Vec3 eye, int threads)
    : eye_(eye), base_m_(field.lowest_m()) {
  if (field.is_empty() || eye.z >= base_m_) return;
  cells_ = for_each_slot<CloudVeil>(kAround * kUp, threads, [&](std::size_t i) {
    return cell_of(field, model, eye, static_cast<int>(i % kAround), static_cast<int>(i / kAround));
  });
}

std::optional<CloudVeil> CloudDome::along(Vec3 from, Vec3 direction) const {
  if (cells_.empty() || from.z >= base_m_ || direction.z <= 0) return std::nullopt;
  const Vec3 seen = unit(from + direction * ((base_m_ - from.z) / direction.z) - eye_);
  const double turn = std::atan2(seen.y, seen.x) / (2 * std::numbers::pi);
  const int column = std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * kAround), kAround - 1),
            row = std::clamp(static_cast<int>(seen.z * kUp), 0, kUp - 1);
  return cells_[static_cast<std::size_t>(row * kAround + column)];
}

}  // namespace citykiln::preview
