#include "preview/clouds/cloud_shadow.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/system/for_each_slot.h"

namespace citykiln::preview {
namespace {

// Cells along a side of each table.
constexpr int kCells = 256;
constexpr double kNearCell_m = 32, kFarCell_m = 256;

// Lower suns throw shadows over tens of kilometres: these are followed by rays.
constexpr double kLowestSun = 0.05;

// Below the lowest base, so that rays from the plane meet all clouds.
constexpr double kBelowBase_m = 1;

}  // namespace

CloudShadow::CloudShadow(const CloudField& field, Vec3 to_sun, Vec2 middle, int threads)
    : to_sun_(to_sun), plane_m_(field.lowest_m() - kBelowBase_m), middle_(middle) {
  if (field.is_empty() || to_sun.z < kLowestSun) return;
  near_ = table_of(field, kNearCell_m, threads);
  far_ = table_of(field, kFarCell_m, threads);
}

CloudShadow::Table CloudShadow::table_of(const CloudField& field, double cell_m, int threads) const {
  const auto row = [&](std::size_t y) {
    std::vector<float> shares(kCells);
    for (int x = 0; x < kCells; ++x) {
      const Vec2 off = Vec2{x - kCells / 2 + 0.5, static_cast<double>(y) - kCells / 2 + 0.5} * cell_m;
      shares[static_cast<std::size_t>(x)] = static_cast<float>(field.sun_passed(at_height(middle_ + off, plane_m_)));
    }
    return shares;
  };
  Table table{.cell_m = cell_m, .passed = {}};
  for (const std::vector<float>& shares : for_each_slot<std::vector<float>>(kCells, threads, row))
    table.passed.insert(table.passed.end(), shares.begin(), shares.end());
  return table;
}

std::optional<double> CloudShadow::passed(Vec3 from) const {
  if (near_.passed.empty() || from.z > plane_m_) return std::nullopt;
  const Vec2 at = in_plan(from) + in_plan(to_sun_) * ((plane_m_ - from.z) / to_sun_.z) - middle_;
  for (const Table* table : {&near_, &far_}) {
    const double x = at.x / table->cell_m + kCells / 2 - 0.5, y = at.y / table->cell_m + kCells / 2 - 0.5;
    if (x < 0 || y < 0 || x >= kCells - 1 || y >= kCells - 1) continue;
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const double u = x - std::floor(x), v = y - std::floor(y);
    const float* first = &table->passed[row * kCells + column];
    return (first[0] * (1 - u) + first[1] * u) * (1 - v) + (first[kCells] * (1 - u) + first[kCells + 1] * u) * v;
  }
  return std::nullopt;
}

}  // namespace citykiln::preview
