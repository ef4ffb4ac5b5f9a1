#include "compiler/assume/roofs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <numeric>
#include <set>

#include "compiler/assume/heights.h"
#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::assume {
namespace {

using map::BuildingClass;
using map::BuildingTradition;
using map::CountryGroup;
using materials::Material;
using roofs::RoofForm;

// Dwellings, shops and buildings of unknown use without and with a neighbour that they touch; all with assumed roofs.
enum class RoofKind : std::uint8_t { kAlone, kInRow, kAny };

constexpr std::array kForms{RoofForm::kFlat,       RoofForm::kGabled,  RoofForm::kHipped,
                            RoofForm::kHalfHipped, RoofForm::kMansard, RoofForm::kSkillion};

struct RoofRow {
  CountryGroup group{};
  RoofKind kind{};
  double storeys_to = 0, area_to_m2 = 0;
  std::array<std::uint32_t, kForms.size()> percent{};
  double pitch_deg = 0;
  Material pitched{};
  BuildingTradition tradition = BuildingTradition::kOther;  // kOther: any
  double storeys_from = 0;
};

constexpr RoofRow kRoofRows[] = {
#define ROOFS(group, kind, storeys, area, flat, gabled, hipped, half_hipped, mansard, skillion, pitch, material)      \
  {CountryGroup::group, RoofKind::kind, storeys, area, {flat, gabled, hipped, half_hipped, mansard, skillion}, pitch, \
   Material::material},
#define ROOFS_OF(tradition, from, group, kind, to, area, flat, gabled, hipped, half_hipped, mansard, skillion, pitch, \
                 material)                                                                                            \
  {CountryGroup::group,                                                                                               \
   RoofKind::kind,                                                                                                    \
   to,                                                                                                                \
   area,                                                                                                              \
   {flat, gabled, hipped, half_hipped, mansard, skillion},                                                            \
   pitch,                                                                                                             \
   Material::material,                                                                                                \
   BuildingTradition::tradition,                                                                                      \
   from},
#include "compiler/assume/roofs.inc"
#undef ROOFS_OF
#undef ROOFS
};
static_assert(std::ranges::all_of(kRoofRows, [](const RoofRow& row) {
  return std::accumulate(row.percent.begin(), row.percent.end(), 0u) == 100;
}));

// The roof of a mansard has its steep slopes below; the pitch of a row is meant for the others.
bool has_row_pitch(RoofForm form) { return form != RoofForm::kFlat && form != RoofForm::kMansard; }

bool is_dwelling(BuildingClass building_class) {
  switch (building_class) {
    case BuildingClass::kPlain:
    case BuildingClass::kHouse:
    case BuildingClass::kApartments:
    case BuildingClass::kHotel:
    case BuildingClass::kShop:
      return true;
    default:
      return false;
  }
}

bool has_assumed_roof(BuildingClass building_class) {
  return has_assumed_storeys(building_class) && building_class != BuildingClass::kHall &&
         building_class != BuildingClass::kBarn;
}

bool is_roof_silent(const map::Footprint& f) {
  return !f.has_roof_shape && f.roof.height_m == 0 && !f.has_parts && !f.is_open && f.min_height_m == 0 &&
         has_assumed_roof(static_cast<BuildingClass>(f.building_class));
}

double storeys_below_roof(const map::Footprint& f) {
  return f.levels > 0 ? f.levels : f.height_m / map::values_of(static_cast<BuildingClass>(f.building_class)).level_m;
}

const RoofRow& roof_row(const map::Footprint& f, const HeightFacts& facts) {
  const RoofKind kind = !is_dwelling(facts.building_class) ? RoofKind::kAny
                        : facts.touching_count > 0         ? RoofKind::kInRow
                                                           : RoofKind::kAlone;
  const auto row = std::ranges::find_if(kRoofRows, [&](const RoofRow& each) {
    return each.group == f.country && (each.kind == kind || each.kind == RoofKind::kAny) &&
           (each.tradition == BuildingTradition::kOther || each.tradition == f.tradition) &&
           storeys_below_roof(f) >= each.storeys_from && storeys_below_roof(f) <= each.storeys_to &&
           facts.area_m2 <= each.area_to_m2;
  });
  // the last row of each group holds for nearly all
  return row != std::end(kRoofRows) ? *row : kRoofRows[std::size(kRoofRows) - 1];
}

RoofForm drawn_form(const RoofRow& row, std::uint32_t percent) {
  for (std::size_t i = 0; i < kForms.size(); ++i) {
    if (percent < row.percent[i]) return kForms[i];
    percent -= row.percent[i];
  }
  return kForms.front();
}

// The direction of the longest wall shared with a neighbour, along which a roof in a row slopes; nothing if no whole
// edge is shared.
std::optional<Vec2> party_wall_direction(std::uint32_t entry, const map::FeatureView& features,
                                         const HeightIndex& index) {
  const Ring& ring = features.footprints[index.footprints[entry]].polygon.outer;
  const auto lies_on = [](const Ring& other, Vec2 p) { return distance_to_ring(other, p) <= kHeightTouching_m; };
  double longest_m = 0;
  std::optional<Vec2> direction;
  for (const std::uint32_t k : index.touching[entry]) {
    const Ring& other = features.footprints[index.footprints[k]].polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      if (distance(a, b) <= longest_m || !lies_on(other, (a + b) * 0.5)) continue;
      longest_m = distance(a, b), direction = unit(b - a);
    }
  }
  return direction;
}

// Between party walls a mansard has slopes on two sides only. Both forms are covered with zinc.
void set_mansard(const std::optional<Vec2>& party_wall, map::Footprint& f) {
  constexpr double kPitch_deg = 36;
  f.roof.form = party_wall ? RoofForm::kGambrel : RoofForm::kMansard;
  if (f.roof.angle_deg == 0) f.roof.angle_deg = kPitch_deg;
  if (!f.roof.direction) f.roof.direction = party_wall;
  if (!f.roof_material && !f.roof_colour) f.roof_material = Material::kMetalRoof;
}

void set_roof(const RoofRow& row, RoofForm form, const std::optional<Vec2>& party_wall, map::Footprint& f) {
  f.has_roof_shape = true;
  f.roof.form = form;
  if (form == RoofForm::kMansard && row.tradition != BuildingTradition::kOther) set_mansard(party_wall, f);
  if (has_row_pitch(form) && f.roof.angle_deg == 0) f.roof.angle_deg = row.pitch_deg;
  if (form == RoofForm::kGabled && !f.roof.direction) f.roof.direction = party_wall;
  if (!f.roof_material && !f.roof_colour && form != RoofForm::kFlat) f.roof_material = row.pitched;
  f.assumed |= bit_of(Assumption::kRoofs);
}

}  // namespace

std::vector<map::Footprint> assume_roofs(const map::FeatureView& features, std::uint64_t seed, Report& report) {
  const HeightIndex index = index_heights(features);
  std::vector<map::Footprint> footprints(features.footprints.begin(), features.footprints.end());
  std::set<OsmId> counted;
  for (std::uint32_t i = 0; i < index.footprints.size(); ++i) {
    map::Footprint& f = footprints[index.footprints[i]];
    if (!is_roof_silent(f)) continue;
    const RoofRow& row = roof_row(f, index.facts[i]);
    const StableId member = stable_id(drawing_member(i, features, index, seed));
    const RoofForm form = drawn_form(row, RandomSequence(seed, member, "roof shape").below(100, 0));
    set_roof(row, form, party_wall_direction(i, features, index), f);
    if (counted.insert(f.id.osm).second) report.count_assumed(Assumption::kRoofs, f.id.osm);
  }
  return footprints;
}

}  // namespace citykiln::assume
