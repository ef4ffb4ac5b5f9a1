#include "compiler/fields/open_land.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/derived_id.h"
#include "compiler/fields/thinned.h"
#include "compiler/geometry/polygons/overlay.h"

namespace citykiln::fields {
namespace {

using map::LandCoverClass;

constexpr double kOpenBucket_m = 128;
// Smaller areas of farmland, such as a kitchen garden, say nothing about the country.
constexpr double kLeastFarm_m2 = 5000;
constexpr double kBuildingsPerM2 = 1 / 20000.0;
// Fields keep to outlines of land use within a few of these distances.
constexpr double kThinOutline_m = 1;
// The highest priority of crops and pieces of meadows (land_cover_classes.inc).
constexpr int kFieldPriority = 32;
// Squares have numbers below 2^40: rows of 2^20 columns.
constexpr std::int64_t kSquaresInRow = 1 << 20;

bool is_farming(const map::AreaFeature& area) {
  return map::values_of(area.surface).group == map::LandCoverGroup::kFarm || area.surface == LandCoverClass::kMeadow;
}

std::int64_t square_number(double v) { return static_cast<std::int64_t>(std::floor(v / kOpenSquare_m)); }

map::AreaFeature open_square(std::int64_t column, std::int64_t row) {
  const Vec2 low{static_cast<double>(column) * kOpenSquare_m, static_cast<double>(row) * kOpenSquare_m};
  const Vec2 high = low + Vec2{kOpenSquare_m, kOpenSquare_m};
  const std::int64_t number = (row + kSquaresInRow / 2) * kSquaresInRow + column + kSquaresInRow / 2;
  return {.id = {{OsmType::kLot, number}, 0},
          .polygon = {{low, {high.x, low.y}, high, {low.x, high.y}}, {}},
          .surface = LandCoverClass::kUnknown,
          .area_m2 = kOpenSquare_m * kOpenSquare_m};
}

// The outline of land that fields would cover: the box of a yard, and other land without points that it hardly bends
// at.
Polygon coarse_outline(const map::AreaFeature& area) {
  if (is_derived(area.id)) {
    const Box2 box = box_of(area.polygon.outer);
    return {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}};
  }
  return {thinned_ring(area.polygon.outer, kThinOutline_m), area.polygon.holes};
}

}  // namespace

std::vector<map::AreaFeature> open_squares(const map::FeatureView& features) {
  std::vector<Box2> farms;
  for (const map::AreaFeature& area : features.areas)
    if (is_farming(area) && area.area_m2 >= kLeastFarm_m2) farms.push_back(box_of(area.polygon.outer));
  std::vector<map::AreaFeature> squares;
  if (farms.empty()) return squares;
  const BoxGrid grid = grid_of(farms, kOpenSquare_m);
  const Box2& extent = features.extent;
  for (std::int64_t row = square_number(extent.min.y); row <= square_number(extent.max.y); ++row)
    for (std::int64_t column = square_number(extent.min.x); column <= square_number(extent.max.x); ++column) {
      map::AreaFeature square = open_square(column, row);
      const Box2 about = box_of(square.polygon.outer).widened(kFarmedAbout_m);
      const auto is_about = [&](std::uint32_t i) { return farms[i].touches(about); };
      if (any_about(grid, about, is_about)) squares.push_back(std::move(square));
    }
  return squares;
}

OpenLand::OpenLand(const map::FeatureView& features) {
  std::vector<Box2> boxes, places;
  for (const map::AreaFeature& area : features.areas) {
    if (area.surface == LandCoverClass::kUnknown || area.polygon.outer.size() < 3) continue;
    areas_.push_back(&area), boxes.push_back(box_of(area.polygon.outer));
  }
  for (const map::Footprint& footprint : features.footprints) {
    if (footprint.polygon.outer.empty() || footprint.is_part) continue;
    buildings_.push_back(box_of(footprint.polygon.outer).centre());
    places.push_back({buildings_.back(), buildings_.back()});
  }
  if (!boxes.empty()) areas_grid_ = grid_of(boxes, kOpenBucket_m);
  if (!places.empty()) buildings_grid_ = grid_of(places, kOpenBucket_m);
}

std::vector<Polygon> OpenLand::free_parts(const Polygon& field) const {
  const Box2 box = box_of(field.outer);
  const double whole_m2 = area_m2(field);
  std::size_t count = 0;
  if (!buildings_.empty())
    for (const std::uint32_t i : boxes_about(buildings_grid_, box)) count += contains(field, buildings_[i]);
  if (static_cast<double>(count) > whole_m2 * kBuildingsPerM2) return {};
  std::vector<Polygon> taken, below;
  if (!areas_.empty())
    for (const std::uint32_t i : boxes_about(areas_grid_, box)) {
      const map::AreaFeature& area = *areas_[i];
      if (!box_of(area.polygon.outer).touches(box)) continue;
      taken.push_back(area.polygon);
      if (map::values_of(area.surface).priority <= kFieldPriority) below.push_back(coarse_outline(area));
    }
  double left_m2 = taken.empty() ? whole_m2 : 0;
  if (!taken.empty())
    for (const Polygon& part : difference(field, taken)) left_m2 += area_m2(part);
  if (left_m2 < whole_m2 / 2) return {};
  // what lies above fields need not be taken out of them
  std::vector<Polygon> parts = below.empty() ? std::vector{field} : difference(field, below);
  std::erase_if(parts, [](const Polygon& part) { return area_m2(part) < kLeastOpen_m2; });
  return parts;
}

}  // namespace citykiln::fields
