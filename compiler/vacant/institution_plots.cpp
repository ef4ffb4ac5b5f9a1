#include "compiler/vacant/institution_plots.h"

#include <algorithm>
#include <optional>

#include "compiler/contract/derived_id.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/polygons/clip_polygon.h"
#include "compiler/geometry/polygons/overlay.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/vacant/ground_cover.h"
#include "compiler/vacant/plot_parts.h"

namespace citykiln::vacant {
namespace {

using map::BuildingClass;
using map::LandCoverClass;

// Smaller buildings are sheds.
constexpr double kLeastBuilding_m2 = 80, kLeastSchool_m2 = 200;
constexpr double kPavingAbout_m = 2.5, kGravelAbout_m = 4;
constexpr double kPlayground_m = 24, kWidestPlayground_m = 44;
constexpr double kLeastFree = 0.85;
// Trees along the rim of a playground, on 100 m.
constexpr double kPlaygroundBushes = 6;

bool is_institution(LandCoverClass surface) {
  return surface == LandCoverClass::kInstitution || surface == LandCoverClass::kReligious;
}

// The land of an institution at a place; null if there is none. The smallest area counts.
const ground::LandCoverPolygon* institution_at(const PlotInputs& inputs, Vec2 p) {
  const ground::LandCoverPolygon* smallest = nullptr;
  for (const ground::LandCoverPolygon& area : inputs.areas) {
    if (!is_institution(area.surface) || !ground::box_of(area).contains(p)) continue;
    const bool is_smaller = smallest == nullptr || area.area_m2 < smallest->area_m2;
    if (is_smaller && ground::winding_number(area, p) > 0) smallest = &area;
  }
  return smallest;
}

// The rectangle about a footprint along its longest edge, widened.
std::optional<PlotRectangle> rectangle_about(const Ring& ring, double widened_m) {
  Vec2 along{};
  double longest_m = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    if (length(edge) > longest_m) longest_m = length(edge), along = unit(edge);
  }
  if (longest_m == 0) return std::nullopt;
  const Vec2 back = left_of(along);
  double low_x = dot(ring[0], along), high_x = low_x, low_y = dot(ring[0], back), high_y = low_y;
  for (const Vec2 p : ring) {
    low_x = std::min(low_x, dot(p, along)), high_x = std::max(high_x, dot(p, along));
    low_y = std::min(low_y, dot(p, back)), high_y = std::max(high_y, dot(p, back));
  }
  return PlotRectangle{.corner = along * (low_x - widened_m) + back * (low_y - widened_m),
                       .along = along,
                       .back = back,
                       .width_m = high_x - low_x + 2 * widened_m,
                       .depth_m = high_y - low_y + 2 * widened_m};
}

// The rectangle beside a side of another, from 0 on: front, right, rear, left.
PlotRectangle beside(const PlotRectangle& r, int side, double depth_m) {
  const bool is_across = side % 2 == 1;
  const double length_m = is_across ? r.depth_m : r.width_m, width_m = std::min(length_m, kWidestPlayground_m);
  const double from_m = (length_m - width_m) / 2;
  PlotRectangle made{.corner = {}, .along = {}, .back = {}, .width_m = width_m, .depth_m = depth_m};
  switch (side) {
    case 0:
      made.corner = r.at(r.width_m - from_m, 0), made.along = r.along * -1.0, made.back = r.back * -1.0;
      break;
    case 1:
      made.corner = r.at(r.width_m, r.depth_m - from_m), made.along = r.back * -1.0, made.back = r.along;
      break;
    case 2:
      made.corner = r.at(from_m, r.depth_m), made.along = r.along, made.back = r.back;
      break;
    default:
      made.corner = r.at(0, from_m), made.along = r.back, made.back = r.along * -1.0;
      break;
  }
  return made;
}

// The share of a rectangle's places on top of which the land itself is.
double free_share(const PlotInputs& inputs, const PlotRectangle& r, const ground::LandCoverPolygon& land) {
  int free = 0;
  for (int i = 0; i < kSamples; ++i)
    for (int j = 0; j < kSamples; ++j) {
      const auto* cover = cover_at(inputs, r.at((i + 0.5) / kSamples * r.width_m, (j + 0.5) / kSamples * r.depth_m));
      free += cover != nullptr && cover->id == land.id;
    }
  return static_cast<double>(free) / (kSamples * kSamples);
}

// The part of a ring in the rings of an area.
std::vector<Ring> part_in(const Ring& ring, const ground::LandCoverPolygon& area) {
  const Polygon whole{ring, {}};
  const Box2 box = box_of(ring).widened(1);
  std::vector<Ring> near;
  for (const Ring& each : area.rings)
    if (Ring trimmed = trimmed_to(each, box); trimmed.size() >= 3) near.push_back(std::move(trimmed));
  const std::vector<Polygon> outside = difference(whole, united(near));
  std::vector<Ring> rings;
  for (const Polygon& inside : difference(whole, outside))
    for (Ring& each : copied_rings(inside)) rings.push_back(std::move(each));
  return rings;
}

struct InstitutionPlotter {
  const PlotInputs& inputs;
  Plots& plots;
  std::uint32_t number = 0;

  void add_surface(LandCoverClass surface, const PlotRectangle& r, const ground::LandCoverPolygon& land) {
    const Ring ring = ring_of(r);
    std::vector<Ring> rings = part_in(ring, land);
    if (rings.empty()) return;
    plots.surfaces.push_back(
        surface_on(surface, derived_id({land.id.osm, 0}, 0), map::values_of(land.surface).priority, std::move(rings)));
  }

  void add_playground(const buildings::Building& school, const PlotRectangle& about,
                      const ground::LandCoverPolygon& land) {
    std::optional<PlotRectangle> best;
    double most = kLeastFree;
    for (int side = 0; side < 4; ++side) {
      const PlotRectangle r = beside(about, side, kPlayground_m);
      const double free = is_in_tile(inputs, ring_of(r)) ? free_share(inputs, r, land) : 0;
      if (free > most) most = free, best = r;
    }
    if (!best) return;
    const ObjectId id{school.id.osm, school.id.part};
    plots.grounds.push_back(ground_of(*best, id, lots::LotKind::kSchool, school.country));
    add_surface(LandCoverClass::kAsphaltYard, *best, land);
    add_bushes(inputs, *best, derived_id({land.id.osm, 0}, ++number), kPlaygroundBushes, 0, plots);
  }

  void add(const buildings::Building& building) {
    const double area = area_m2(building.footprint);
    if (!building.stands_on_ground || area < kLeastBuilding_m2) return;
    const ground::LandCoverPolygon* land = institution_at(inputs, centroid(building.footprint));
    if (land == nullptr) return;
    const auto own = static_cast<BuildingClass>(building.building_class);
    const bool is_church = own == BuildingClass::kChurch;
    const auto about = rectangle_about(building.footprint.outer, is_church ? kGravelAbout_m : kPavingAbout_m);
    if (!about || !is_in_tile(inputs, ring_of(*about))) return;
    add_surface(is_church ? LandCoverClass::kGravelYard : LandCoverClass::kYardPath, *about, *land);
    if (is_church)
      plots.grounds.push_back(ground_of(*about, building.id, lots::LotKind::kChurch, building.country));
    else if (own == BuildingClass::kSchool && area >= kLeastSchool_m2)
      add_playground(building, *about, *land);
  }
};

}  // namespace

void add_institution_plots(const PlotInputs& inputs, Plots& plots) {
  if (std::ranges::none_of(inputs.areas, [](const auto& area) { return is_institution(area.surface); })) return;
  InstitutionPlotter plotter{inputs, plots};
  for (const buildings::Building& building : inputs.buildings) plotter.add(building);
}

}  // namespace citykiln::vacant
