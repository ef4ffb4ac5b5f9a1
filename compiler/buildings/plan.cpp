#include "compiler/buildings/plan.h"

#include <algorithm>
#include <optional>

#include "compiler/geometry/snap.h"
#include "compiler/map/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using map::Footprint;
using materials::Material;

// Walls reach this far below the lowest corner: the ground may sag by a coarse level's tolerance, and no gap shall open under a wall.
constexpr double kFoundation_m = 1;
// What must be seen of a building above its highest corner.
constexpr double kLeastRise_m = 2;

struct GroundRange {
  double low_m, high_m;
};

GroundRange ground_under(const Polygon& footprint, const map::Heightfield& heights) {
  GroundRange range{1e9, -1e9};
  for (const Vec2 p : footprint.outer) {
    const double z = map::height_m_at(heights, p);
    range = {std::min(range.low_m, z), std::max(range.high_m, z)};
  }
  return range;
}

// Outlines by their western edge, so that the one around a point is found among few.
struct Outlines {
  std::vector<const Footprint*> sorted;
  double widest_m = 0;
};

Outlines sort_outlines(const std::vector<Footprint>& footprints) {
  Outlines outlines;
  for (const Footprint& f : footprints)
    if (!f.is_part) {
      outlines.sorted.push_back(&f);
      outlines.widest_m = std::max(outlines.widest_m, box_of(f.polygon.outer).width());
    }
  std::stable_sort(outlines.sorted.begin(), outlines.sorted.end(),
                   [](const Footprint* a, const Footprint* b) { return box_of(a->polygon.outer).min.x < box_of(b->polygon.outer).min.x; });
  return outlines;
}

const Footprint* outline_around(const Outlines& outlines, Vec2 p) {
  const auto first = std::lower_bound(outlines.sorted.begin(), outlines.sorted.end(), p.x - outlines.widest_m,
                                      [](const Footprint* f, double x) { return box_of(f->polygon.outer).min.x < x; });
  for (auto at = first; at != outlines.sorted.end() && box_of((*at)->polygon.outer).min.x <= p.x; ++at)
    if (contains((*at)->polygon, p)) return *at;
  return nullptr;
}

Material wall_of(const Footprint& f, double area_m2) {
  if (f.wall_material) return *f.wall_material;
  switch (static_cast<BuildingClass>(f.building_class)) {
    case BuildingClass::kChurch: return Material::kStone;
    case BuildingClass::kHall: return Material::kMetalCladding;
    case BuildingClass::kBarn:
    case BuildingClass::kHut: return Material::kTimber;
    case BuildingClass::kGreenhouse: return Material::kGlassFacade;
    case BuildingClass::kGarage:
    case BuildingClass::kRoof: return Material::kConcrete;
    case BuildingClass::kOffice: return f.height_m > 30 ? Material::kGlassFacade : Material::kPlaster;
    default: break;
  }
  // tall and slim is glass, tall and wide is concrete, the rest is plastered
  if (f.height_m > 75) return Material::kGlassFacade;
  return f.height_m > 35 && area_m2 > 500 ? Material::kConcrete : Material::kPlaster;
}

Material roof_of(const Footprint& f, double area_m2) {
  if (f.roof_material) return *f.roof_material;
  switch (static_cast<BuildingClass>(f.building_class)) {
    case BuildingClass::kHouse:
    case BuildingClass::kBarn: return Material::kRoofTile;
    case BuildingClass::kChurch: return Material::kSlate;
    case BuildingClass::kHall: return Material::kMetalRoof;
    case BuildingClass::kGreenhouse: return Material::kGlassFacade;
    case BuildingClass::kPlain:
    case BuildingClass::kApartments:
    case BuildingClass::kCivic: return f.height_m < 18 && area_m2 < 600 ? Material::kRoofTile : Material::kFlatRoof;
    default: return Material::kFlatRoof;
  }
}

Building building_of(const Footprint& f, GroundRange ground, Report& report) {
  Building building;
  building.id = f.id, building.footprint = f.polygon;
  const double area = area_m2(f.polygon);
  building.stands_on_ground = f.min_height_m == 0;
  building.bottom_m = snapped(building.stands_on_ground ? ground.low_m - kFoundation_m : ground.low_m + f.min_height_m);
  double top_m = ground.low_m + f.height_m;
  if (top_m < ground.high_m + kLeastRise_m && building.stands_on_ground) {
    report.add(Code::kHeightRaised, f.id.osm, ground.high_m + kLeastRise_m - top_m);
    top_m = ground.high_m + kLeastRise_m;
  }
  building.top_m = std::max(snapped(top_m), building.bottom_m + kQuantum_m);
  building.wall = wall_of(f, area), building.roof = roof_of(f, area);
  building.wall_colour = f.wall_colour, building.roof_colour = f.roof_colour;
  return building;
}

}  // namespace

std::vector<Building> plan(const map::Features& features, const map::Heightfield& heights, Report& report) {
  std::vector<Building> buildings;
  Account account;
  const Outlines outlines = sort_outlines(features.footprints);
  for (const Footprint& f : features.footprints) {
    ++account.in;
    if (f.has_parts) {
      report.add(Code::kOutlineReplacedByParts, f.id.osm);
      ++account.merged;
      continue;
    }
    // parts of one building count their heights from one ground
    const Footprint* outline = f.is_part ? outline_around(outlines, box_of(f.polygon.outer).centre()) : nullptr;
    ++account.out;
    buildings.push_back(building_of(f, ground_under(outline != nullptr ? outline->polygon : f.polygon, heights), report));
  }
  report.account("buildings", "footprint") = account;
  return buildings;
}

}  // namespace citykiln::buildings
