#include "compiler/buildings/plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compiler/buildings/dress.h"
#include "compiler/buildings/outline_index.h"
#include "compiler/geometry/snap.h"
#include "compiler/geometry/triangulate.h"

namespace citykiln::buildings {
namespace {

// A building shows at least this much over its highest corner: a low storey. Less is a slip of the heightmap, not a
// building.
constexpr double kLeastRise_m = 2;

// How deep walls reach under the lowest corner: the ground may dip between two corners, and coarse levels lie a little
// lower.
constexpr double kFoundation_m = 3;

struct GroundRange {
  double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -std::numeric_limits<double>::infinity();
};

// Along the walls the ground is looked at this often: banks beside roads are a few metres wide.
constexpr double kWallStep_m = 4;

GroundRange ground_under(const Polygon& polygon, const ground::Carving& ground) {
  GroundRange range;
  Vec2 from = polygon.outer.back();
  for (const Vec2 to : polygon.outer) {
    const double steps = std::max(1.0, std::ceil(distance(from, to) / kWallStep_m));
    for (double i = 1; i <= steps; ++i) {
      const double z = land_m(ground, from + (to - from) * (i / steps));
      range = {std::min(range.lowest_m, z), std::max(range.highest_m, z)};
    }
    from = to;
  }
  return range;
}

// A point well inside: the middle of the largest triangle.
Vec2 inner_point(const Polygon& polygon) {
  const PlaneTriangles t = triangulate(polygon);
  double largest = 0;
  Vec2 middle = polygon.outer.front();
  for (const auto& [ia, ib, ic] : t.triangles) {
    const Vec2 a = t.points[ia], b = t.points[ib], c = t.points[ic];
    if (cross(b - a, c - a) <= largest) continue;
    largest = cross(b - a, c - a);
    middle = (a + b + c) * (1 / 3.0);
  }
  return middle;
}

// The height that a footprint's heights count from.
double base_of(const map::Footprint& footprint, const GroundRange& under, const OutlineIndex& outlines,
               const ground::Carving& ground) {
  if (!footprint.is_part) return under.lowest_m;
  const map::Footprint* outline = outline_at(outlines, inner_point(footprint.polygon));
  return outline == nullptr ? under.lowest_m : ground_under(outline->polygon, ground).lowest_m;
}

double lift_of(const map::Footprint& footprint, Report& report) {
  if (footprint.min_height_m <= 0) return 0;
  if (footprint.min_height_m < footprint.height_m) return footprint.min_height_m;
  report.add(Code::kUpsideDown, footprint.id.osm, footprint.min_height_m - footprint.height_m);
  return 0;
}

// Where the building ends at the top: raised out of a slope that would bury it.
double top_of(const map::Footprint& footprint, double base_m, const GroundRange& ground, Report& report) {
  const double top_m = snapped(base_m + footprint.height_m), least_m = snapped(ground.highest_m + kLeastRise_m);
  if (top_m >= least_m) return top_m;
  report.add(Code::kHeightRaised, footprint.id.osm, least_m - top_m);
  return least_m;
}

Building build(const map::Footprint& footprint, const OutlineIndex& outlines, const ground::Carving& ground,
               Report& report) {
  const GroundRange under = ground_under(footprint.polygon, ground);
  const double base_m = base_of(footprint, under, outlines, ground);
  const double lift_m = lift_of(footprint, report);
  const Dress dress = dress_of(footprint);
  Building building{footprint.id,          footprint.polygon,    0, 0, lift_m == 0, dress.wall, dress.roof,
                    footprint.wall_colour, footprint.roof_colour};
  building.top_m = top_of(footprint, base_m, under, report);
  building.bottom_m = snapped(lift_m > 0 ? base_m + lift_m : std::min(base_m, under.lowest_m) - kFoundation_m);
  return building;
}

}  // namespace

std::vector<Building> plan(const map::Features& features, const ground::Carving& ground, Report& report) {
  std::vector<Building> buildings;
  Account account;
  const OutlineIndex outlines = index_outlines(features.footprints);
  for (const map::Footprint& footprint : features.footprints) {
    ++account.in;
    if (footprint.polygon.outer.size() < 3) {
      report.drop(account, Code::kDegenerateRing, footprint.id.osm);
    } else if (footprint.has_parts) {
      ++account.merged;
      report.add(Code::kOutlineReplacedByParts, footprint.id.osm);
    } else {
      ++account.out;
      buildings.push_back(build(footprint, outlines, ground, report));
    }
  }
  report.account("buildings", "footprint") = account;
  std::sort(buildings.begin(), buildings.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return buildings;
}

}  // namespace citykiln::buildings
