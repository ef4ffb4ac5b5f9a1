#include "compiler/ground/mesh/split_borders.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/mesh/refine.h"

namespace citykiln::ground {
namespace {

// A point of a border.
struct Point {
  GridPoint at;
  Heights heights;
  std::uint32_t face;  // of the reference
};

Point reference_point_at(const Reference& reference, GridPoint at) {
  const Place place = place_at(reference, plane_point(at));
  return {at, snapped_heights(reference, place), place.face};
}

EdgeEnd end_at(const Point& point, HeightLayer layer) {
  return {at_height(plane_point(point.at), layer_height_m(point.heights, layer)), point.face};
}

WorstPoint worst_of(const Reference& reference, const Point& a, const Point& b, std::span<const HeightLayer> layers) {
  // all layers are the terrain's
  if (reference.terrain != nullptr && !layers.empty()) layers = layers.first(1);
  WorstPoint worst;
  for (const HeightLayer layer : layers) {
    const WorstPoint here = worst_on_shared_edge(reference, end_at(a, layer), end_at(b, layer), layer);
    if (here.error_m > worst.error_m) worst = here;
  }
  return worst;
}

// The grid points to which places of a border are rounded.
struct GridRange {
  GridPoint min, max;
  GridPoint nearest(Vec2 place) const {
    const GridPoint p = grid_point(place);
    return {std::clamp(p.x, min.x, max.x), std::clamp(p.y, min.y, max.y)};
  }
};

GridRange whole_range(const Box2& cell) { return {grid_point(cell.min), grid_point(cell.max)}; }

// A border inside the cell has no point on the cell's border: what lies beside that must stay.
GridRange inner_range(const Box2& cell) {
  const auto [min, max] = whole_range(cell);
  return {{min.x + 1, min.y + 1}, {max.x - 1, max.y - 1}};
}

// How a border is followed.
struct Following {
  std::span<const HeightLayer> layers;
  double tolerance_m;
  GridRange range;
};

// Splits an edge at its worst place until no piece is off by more than the tolerance. Depends on the edge and the
// heights alone. Each piece has a smaller box than the edge, so it ends.
void split_edge(const Reference& reference, const Point& a, const Point& b, const Following& following,
                std::vector<GridPoint>& points) {
  const WorstPoint worst = worst_of(reference, a, b, following.layers);
  if (worst.error_m <= following.tolerance_m) return;
  const Point middle = reference_point_at(reference, following.range.nearest(worst.at));
  if (middle.at == a.at || middle.at == b.at) return;
  points.push_back(middle.at);
  split_edge(reference, a, middle, following, points);
  split_edge(reference, middle, b, following, points);
}

// Returns the border's points from the lower end to the upper.
std::vector<GridPoint> path_of(const Reference& reference, const Border& border, const Following& following) {
  std::vector<GridPoint> path = {border.a, border.b};
  split_edge(reference, reference_point_at(reference, border.a), reference_point_at(reference, border.b), following,
             path);
  const auto along = [&](GridPoint p) {
    return (p.x - border.a.x) * (border.b.x - border.a.x) + (p.y - border.a.y) * (border.b.y - border.a.y);
  };
  std::sort(path.begin(), path.end(), [&](GridPoint p, GridPoint q) { return along(p) < along(q); });
  return path;
}

constexpr std::array kAllLayers = {HeightLayer::kLand, HeightLayer::kRoad, HeightLayer::kCarriageway,
                                   HeightLayer::kWater};

// Returns the layers that a border must follow: those of its sides, except level ones.
std::vector<HeightLayer> layers_beside(const Border& border, std::span<const FaceHeight> heights) {
  std::vector<HeightLayer> layers;
  for (const std::uint32_t surface : {border.left, border.right}) {
    const FaceHeight height = surface == kNoLandCover ? FaceHeight{} : heights[surface];
    if (!height.level_m && std::ranges::find(layers, height.layer) == layers.end()) layers.push_back(height.layer);
  }
  return layers;
}

// The neighbour's polygons may lie on other layers, so the cell's border follows all.
std::vector<GridPoint> path_on_cell_border(const Reference& reference, const Border& border,
                                           const SideTolerances& sides_m) {
  const Box2& cell = reference.cell;
  return path_of(reference, border, {kAllLayers, tolerance_m_of(sides_m, border, cell), whole_range(cell)});
}

}  // namespace

SplitBorders split_borders(const Reference& reference, std::span<const Border> borders,
                           std::span<const FaceHeight> heights, const SideTolerances& sides_m, double inner_m) {
  assert(inner_m >= 0);
  SplitBorders bent;
  for (const Border& border : borders) {
    if (!border.is_cell_border) continue;
    const auto path = path_on_cell_border(reference, border, sides_m);
    bent.points.insert(bent.points.end(), path.begin(), path.end());
    bent.borders.push_back(border);
  }
  for (const Border& border : borders) {
    if (border.is_cell_border) continue;
    const std::vector<HeightLayer> layers = layers_beside(border, heights);
    const auto path = path_of(reference, border, {layers, inner_m, inner_range(reference.cell)});
    for (std::size_t i = 1; i < path.size(); ++i)
      bent.borders.push_back({path[i - 1], path[i], border.left, border.right, false});
  }
  return bent;
}

}  // namespace citykiln::ground
