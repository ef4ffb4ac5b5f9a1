#include "compiler/surroundings/open_water.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace citykiln::surroundings {
namespace {

// Coastlines decide up to this distance, heightmaps beyond it.
constexpr double kNearCoast_m = 1000;
// A lake on a shorter part of the border ends.
constexpr double kWideBorder_m = 1000, kLookStep_m = 32;
// Polygons may end at the extent's sides.
constexpr double kInside_m = 0.5;
constexpr std::int32_t kLevelTolerance_m = 1;

Vec2 moved_inside(const Box2& box, Vec2 p) {
  const Vec2 low = box.min + Vec2{kInside_m, kInside_m}, high = box.max - Vec2{kInside_m, kInside_m};
  return {std::clamp(p.x, low.x, high.x), std::clamp(p.y, low.y, high.y)};
}

bool is_in_any(const std::vector<ground::LandCoverPolygon>& polygons, Vec2 p) {
  return std::ranges::any_of(polygons, [&](const auto& polygon) { return ground::winding_number(polygon, p) > 0; });
}

std::int32_t level_of(const ground::LandCoverPolygon& lake) {
  return static_cast<std::int32_t>(std::floor(*lake.level_m + 0.5));
}

bool is_sea_beyond(const MappedWater& water, Vec2 p, std::int32_t height_m) {
  const std::optional<CoastSide> side = water.coast.at(p);
  if (side && !side->is_beyond && side->away_m <= kNearCoast_m) return side->is_sea;
  return height_m <= 0;
}

void find_open_sea(const MappedWater& water, const Box2& extent, const std::vector<bool>& known, Surroundings& around) {
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column) {
      const std::size_t at = around.index(column, row);
      const Vec2 p = around.vertex(column, row);
      const bool is_sea = extent.contains(p) ? is_in_any(water.sea, moved_inside(extent, p))
                                             : known[at] && is_sea_beyond(water, p, around.heights_m[at]);
      if (is_sea) around.covers[at] = Cover::kSea, around.heights_m[at] = 0;
    }
}

// A crossing of lines.
struct Crossing {
  std::size_t column, row;
};

// Adds the crossing if it belongs to the lake.
void flood(const std::vector<bool>& known, std::int32_t level_m, Crossing at, Surroundings& around,
           std::vector<Crossing>& reached) {
  const std::size_t i = around.index(at.column, at.row);
  const bool is_level = known[i] && std::abs(around.heights_m[i] - level_m) <= kLevelTolerance_m;
  if (!is_level || around.covers[i] != Cover::kLand) return;
  around.covers[i] = Cover::kLake, around.heights_m[i] = level_m;
  reached.push_back(at);
}

std::vector<Crossing> crossings_in(const ground::LandCoverPolygon& lake, const Box2& extent, Surroundings& around) {
  std::vector<Crossing> inside;
  for (std::size_t row = 0; row < around.rows(); ++row)
    for (std::size_t column = 0; column < around.columns(); ++column) {
      const Vec2 p = around.vertex(column, row);
      if (!extent.contains(p) || ground::winding_number(lake, moved_inside(extent, p)) <= 0) continue;
      const std::size_t i = around.index(column, row);
      around.covers[i] = Cover::kLake, around.heights_m[i] = level_of(lake);
      inside.push_back({column, row});
    }
  return inside;
}

void find_lake(const ground::LandCoverPolygon& lake, const Box2& extent, const std::vector<bool>& known,
               Surroundings& around) {
  std::vector<Crossing> reached = crossings_in(lake, extent, around);
  const auto visit = [&](std::size_t column, std::size_t row) {
    if (!extent.contains(around.vertex(column, row))) flood(known, level_of(lake), {column, row}, around, reached);
  };
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const auto [column, row] = reached[next];
    if (column > 0) visit(column - 1, row);
    if (row > 0) visit(column, row - 1);
    if (column + 1 < around.columns()) visit(column + 1, row);
    if (row + 1 < around.rows()) visit(column, row + 1);
  }
}

}  // namespace

bool reaches_beyond(const ground::LandCoverPolygon& water, const Box2& extent) {
  if (!water.level_m || map::values_of(water.surface).group != map::LandCoverGroup::kWater) return false;
  const Box2 box = box_of(water), inside = extent.widened(-kInside_m);
  if (inside.contains(box.min) && inside.contains(box.max)) return false;
  double wet_m = 0;
  const auto look_at = [&](double x, double y) {
    if (ground::winding_number(water, moved_inside(extent, {x, y})) > 0) wet_m += kLookStep_m;
  };
  for (double x = extent.min.x; x < extent.max.x; x += kLookStep_m) look_at(x, extent.min.y), look_at(x, extent.max.y);
  for (double y = extent.min.y; y < extent.max.y; y += kLookStep_m) look_at(extent.min.x, y), look_at(extent.max.x, y);
  return wet_m >= kWideBorder_m;
}

void find_open_water(const MappedWater& water, const Box2& extent, const std::vector<bool>& known,
                     Surroundings& around) {
  around.covers.assign(around.heights_m.size(), Cover::kLand);
  if (water.has_sea()) find_open_sea(water, extent, known, around);
  for (const ground::LandCoverPolygon& lake : water.lakes) find_lake(lake, extent, known, around);
}

std::optional<Cover> cover_by_coast(const MappedWater& water, Vec2 place) {
  const std::optional<CoastSide> side = water.coast.at(place);
  if (!side) return std::nullopt;
  return side->is_sea ? Cover::kSea : Cover::kLand;
}

}  // namespace citykiln::surroundings
