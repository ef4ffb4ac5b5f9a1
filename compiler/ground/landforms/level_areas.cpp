#include "compiler/ground/landforms/level_areas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/ground/levelling/fitted_surface.h"

namespace citykiln::ground {
namespace {

using map::LandCoverClass;

struct LevelRow {
  LandCoverClass surface;
  double most_slope, least_m2, most_m2;
};
constexpr LevelRow kLevelRows[] = {
#define LEVEL(surface, most_slope, least_m2, most_m2) {LandCoverClass::surface, most_slope, least_m2, most_m2},
#include "compiler/ground/landforms/level_areas.inc"
#undef LEVEL
};

// Areas of sports this close to each other have one plane.
constexpr double kTouch_m = 1;
constexpr double kTouchBucket_m = 128;
// Samples of an area across, about.
constexpr double kSamplesAcross = 12;

const LevelRow* level_row_of(const map::AreaFeature& area) {
  const auto fits = [&](const LevelRow& row) {
    return row.surface == area.surface && area.area_m2 >= row.least_m2 && area.area_m2 <= row.most_m2;
  };
  const auto row = std::ranges::find_if(kLevelRows, fits);
  return row == std::end(kLevelRows) ? nullptr : row;
}

bool is_sport(const map::AreaFeature& area) {
  return map::values_of(area.surface).group == map::LandCoverGroup::kSport;
}

bool touch(const Ring& a, const Ring& b) {
  const auto reaches = [](const Ring& from, const Ring& to) {
    return std::ranges::any_of(
        from, [&](Vec2 p) { return winding_number(to, p) != 0 || distance_to_ring(to, p) <= kTouch_m; });
  };
  return reaches(a, b) || reaches(b, a);
}

// The areas that share a plane with each: the number of one of them.
class PlaneGroups {
 public:
  explicit PlaneGroups(std::span<const map::AreaFeature* const> areas) : group_(areas.size()) {
    std::iota(group_.begin(), group_.end(), 0u);
    std::vector<Box2> boxes;
    for (const map::AreaFeature* area : areas) boxes.push_back(box_of(area->polygon.outer).widened(kTouch_m));
    const BoxGrid grid = grid_of(boxes, kTouchBucket_m);
    for (std::uint32_t a = 0; a < areas.size(); ++a)
      for (const std::uint32_t b : boxes_about(grid, boxes[a]))
        if (b > a && is_sport(*areas[a]) && is_sport(*areas[b]) && boxes[a].touches(boxes[b]) &&
            touch(areas[a]->polygon.outer, areas[b]->polygon.outer))
          group_[of(b)] = of(a);
  }

  std::uint32_t of(std::uint32_t area) const {
    while (group_[area] != area) area = group_[area];
    return area;
  }

 private:
  std::vector<std::uint32_t> group_;
};

// Places of a grid in the area, on lines of whole multiples of its spacing.
void add_samples(const map::AreaFeature& area, const map::Heightfield& heights, std::vector<Vec3>& samples) {
  const Ring& ring = area.polygon.outer;
  const Box2 box = box_of(ring);
  const double apart_m = std::max(0.5, std::floor(std::sqrt(area.area_m2) / kSamplesAcross));
  for (double y = std::ceil(box.min.y / apart_m) * apart_m; y <= box.max.y; y += apart_m)
    for (double x = std::ceil(box.min.x / apart_m) * apart_m; x <= box.max.x; x += apart_m)
      if (winding_number(ring, {x, y}) != 0) samples.push_back({x, y, map::height_m_at(heights, {x, y})});
}

// True where the terrain is the plane: nothing has to be levelled.
bool is_level_already(const FittedSurface& plane, std::span<const Vec3> samples) {
  constexpr double kAlike_m = 1.0 / 64;
  return std::ranges::all_of(samples, [&](const Vec3& s) {
    return std::abs(s.z - plane.height_m({s.x, s.y})) <= kAlike_m;
  });
}

Landform level_landform(const map::AreaFeature& area, const FittedSurface& plane) {
  Landform form;
  form.id = area.id, form.axis = area.polygon.outer;
  form.surface = LandCoverClass::kUnknown, form.kind = LandformKind::kLevel;
  const Vec2 slope = plane.gradient(plane.centre);
  const double east = snapped_to(kTiltQuantum, slope.x), north = snapped_to(kTiltQuantum, slope.y);
  // the plane of the rounded slopes has the fitted height in the middle
  const Vec2 to_start = form.axis.front() - plane.centre;
  const double z_m = plane.height_m(plane.centre) + east * to_start.x + north * to_start.y;
  form.profile = {{0, snapped_to(kProfileQuantum_m, z_m), east}, {1, snapped_to(kProfileQuantum_m, z_m), north}};
  return form;
}

}  // namespace

bool is_level_area(const map::AreaFeature& area) { return level_row_of(area) != nullptr; }

std::vector<Landform> level_areas(std::span<const map::AreaFeature> areas, const map::Heightfield& heights) {
  std::vector<const map::AreaFeature*> level;
  for (const map::AreaFeature& area : areas)
    if (is_level_area(area)) level.push_back(&area);
  const PlaneGroups groups(level);
  std::vector<std::vector<Vec3>> samples(level.size());
  std::vector<double> most_slope(level.size(), 1);
  for (std::uint32_t a = 0; a < level.size(); ++a) {
    const std::uint32_t group = groups.of(a);
    add_samples(*level[a], heights, samples[group]);
    most_slope[group] = std::min(most_slope[group], level_row_of(*level[a])->most_slope);
  }
  std::vector<std::optional<FittedSurface>> planes(level.size());
  for (std::uint32_t g = 0; g < level.size(); ++g) {
    const FittedSurface plane = fitted_surface(samples[g], SurfaceForm::kPlane, most_slope[g]);
    if (!is_level_already(plane, samples[g])) planes[g] = plane;
  }
  std::vector<Landform> forms;
  for (std::uint32_t a = 0; a < level.size(); ++a)
    if (const auto& plane = planes[groups.of(a)]) forms.push_back(level_landform(*level[a], *plane));
  return forms;
}

}  // namespace citykiln::ground
