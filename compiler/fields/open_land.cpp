#include "compiler/fields/open_land.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "compiler/contract/derived_id.h"
#include "compiler/fields/cut_rings.h"
#include "compiler/fields/thinned.h"
#include "compiler/geometry/polygons/clip_polygon.h"
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
constexpr int kCells = 64;
// Areas are clipped this far outside of a square, so that the cuts are on no border of a field.
constexpr double kClipBeyond_m = 1;
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

std::vector<Ring> rings_in(std::vector<Ring> rings, const Box2& box) {
  rings = left_of_cut(rings, box.min, {1, 0});
  rings = left_of_cut(rings, {box.max.x, box.min.y}, {0, 1});
  rings = left_of_cut(rings, box.max, {-1, 0});
  return left_of_cut(rings, {box.min.x, box.max.y}, {0, -1});
}

// The first cell whose centre is at v or beyond it.
int first_cell(double v, double low) {
  return static_cast<int>(std::clamp(std::ceil((v - low) / kOpenCell_m - 0.5), 0.0, double{kCells}));
}

double centre_of_cell(int i, double low) { return low + (i + 0.5) * kOpenCell_m; }

std::uint64_t bits_from(int first) { return first >= kCells ? 0 : ~std::uint64_t{0} << first; }

// Closes the cells whose centres are in the rings.
void close_cells(std::span<const Ring> rings, OpenSquare& square) {
  // each edge turns all cells to the right of it round: an odd number of turns is inside
  std::array<std::uint64_t, kCells> inside{};
  for (const Ring& ring : rings)
    for (std::size_t i = 0, n = ring.size(); i < n; ++i) {
      const Vec2 a = std::min(ring[i], ring[(i + 1) % n]), b = std::max(ring[i], ring[(i + 1) % n]);
      const int first = first_cell(std::min(a.y, b.y), square.low.y),
                last = first_cell(std::max(a.y, b.y), square.low.y);
      for (int row = first; row < last; ++row) {
        const double x = a.x + (b.x - a.x) * ((centre_of_cell(row, square.low.y) - a.y) / (b.y - a.y));
        inside[static_cast<std::size_t>(row)] ^= bits_from(first_cell(x, square.low.x));
      }
    }
  for (std::size_t row = 0; row < kCells; ++row) square.cells[row] &= ~inside[row];
}

// The outline of land that fields would cover: the box of a yard, and other land without points that it hardly bends
// at.
Polygon coarse_outline(const map::AreaFeature& area, const Box2& within) {
  Polygon outline;
  if (is_derived(area.id)) {
    const Box2 box = box_of(area.polygon.outer);
    outline.outer = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
  } else {
    outline = {thinned_ring(area.polygon.outer, kThinOutline_m), area.polygon.holes};
  }
  std::vector<Ring> rings = rings_in(copied_rings(outline), within);
  if (rings.empty()) return {};
  outline = {std::move(rings.front()), {}};
  for (std::size_t i = 1; i < rings.size(); ++i) outline.holes.push_back(std::move(rings[i]));
  return outline;
}

// Closes the cell of a building and those about it.
void close_about(Vec2 building, OpenSquare& square) {
  const Vec2 cell = (building - square.low) * (1 / kOpenCell_m);
  const int column = static_cast<int>(std::floor(cell.x)), row = static_cast<int>(std::floor(cell.y));
  const std::uint64_t bits = bits_from(std::max(column - 1, 0)) & ~bits_from(std::clamp(column + 2, 0, kCells));
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, kCells - 1); ++r)
    square.cells[static_cast<std::size_t>(r)] &= ~bits;
}

void close_steep(const std::function<bool(Vec2)>& is_steep, OpenSquare& square) {
  constexpr std::uint64_t kBlock = (std::uint64_t{1} << kSteepCells) - 1;
  for (int row = 0; row < kCells; row += kSteepCells)
    for (int column = 0; column < kCells; column += kSteepCells) {
      const auto rows = std::span(square.cells).subspan(static_cast<std::size_t>(row), kSteepCells);
      const std::uint64_t block = kBlock << column;
      if (std::ranges::none_of(rows, [&](std::uint64_t cells) { return (cells & block) != 0; })) continue;
      const Vec2 centre = square.low + Vec2{column + kSteepCells / 2.0, row + kSteepCells / 2.0} * kOpenCell_m;
      if (is_steep(centre))
        for (std::uint64_t& cells : rows) cells &= ~block;
    }
}

// The share of the cells of a field that are open.
double open_share(const OpenSquare& square, const Polygon& field) {
  const Box2 box = box_of(field.outer);
  int all = 0, open = 0;
  for (int row = first_cell(box.min.y, square.low.y); row < first_cell(box.max.y, square.low.y); ++row)
    for (int column = first_cell(box.min.x, square.low.x); column < first_cell(box.max.x, square.low.x); ++column) {
      const Vec2 at{centre_of_cell(column, square.low.x), centre_of_cell(row, square.low.y)};
      if (!contains(field, at)) continue;
      ++all, open += is_open(square, at);
    }
  return all == 0 ? 0 : double(open) / all;
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

bool is_open(const OpenSquare& square, Vec2 at) {
  const Vec2 cell = (at - square.low) * (1 / kOpenCell_m);
  if (!(cell.x >= 0 && cell.y >= 0 && cell.x < kCells && cell.y < kCells)) return false;
  return (square.cells[static_cast<std::size_t>(cell.y)] >> static_cast<int>(cell.x) & 1) != 0;
}

double open_m2(const OpenSquare& square) {
  int count = 0;
  for (const std::uint64_t cells : square.cells) count += std::popcount(cells);
  return count * kOpenCell_m * kOpenCell_m;
}

OpenSquare OpenLand::square_at(Vec2 low, const std::function<bool(Vec2)>& is_steep) const {
  OpenSquare square{low, {}, {}};
  square.cells.fill(~std::uint64_t{0});
  const Box2 box = Box2{low, low + Vec2{kOpenSquare_m, kOpenSquare_m}}.widened(kClipBeyond_m);
  if (!areas_.empty())
    for (const std::uint32_t i : boxes_about(areas_grid_, box)) {
      const map::AreaFeature& area = *areas_[i];
      if (!box_of(area.polygon.outer).touches(box)) continue;
      close_cells(rings_in(copied_rings(area.polygon), box), square);
      // what lies above fields need not be taken out of them
      if (map::values_of(area.surface).priority > kFieldPriority) continue;
      if (Polygon outline = coarse_outline(area, box); !outline.outer.empty())
        square.below.push_back(std::move(outline));
    }
  if (!buildings_.empty())
    for (const std::uint32_t i : boxes_about(buildings_grid_, box)) close_about(buildings_[i], square);
  close_steep(is_steep, square);
  return square;
}

bool OpenLand::has_buildings(const Polygon& field) const {
  if (buildings_.empty()) return false;
  std::size_t count = 0;
  for (const std::uint32_t i : boxes_about(buildings_grid_, box_of(field.outer)))
    count += contains(field, buildings_[i]);
  return static_cast<double>(count) > area_m2(field) * kBuildingsPerM2;
}

std::vector<Polygon> OpenLand::free_parts(const OpenSquare& square, const Polygon& field) const {
  if (open_share(square, field) < 0.5 || has_buildings(field)) return {};
  const Box2 box = box_of(field.outer);
  std::vector<Polygon> below;
  for (const Polygon& land : square.below)
    if (box_of(land.outer).touches(box)) below.push_back(land);
  std::vector<Polygon> parts = below.empty() ? std::vector{field} : difference(field, below);
  std::erase_if(parts, [](const Polygon& part) { return area_m2(part) < kLeastOpen_m2; });
  return parts;
}

}  // namespace citykiln::fields
