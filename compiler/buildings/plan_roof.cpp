#include "compiler/buildings/plan_roof.h"

#include <algorithm>

#include "compiler/contract/draw.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/building_classes.h"
#include "grammars/roofs/expected_rise.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using roofs::Form;

constexpr double kSmall_m2 = 350, kSmall_m = 20;
// Wider halls have flat roofs, and hall roofs are low.
constexpr double kHall_m2 = 4000, kHallPitch_deg = 9;
constexpr double kLeastShed_m2 = 9;
// What a roof that nobody told the height of leaves of a told height: half, and room to stand.
constexpr double kMostShare = 0.5, kLeastWall_m = 2.25;
constexpr double kLeastRise_m = 0.25;
constexpr double kEaves_m = 0.375;

Form house_roof(const map::Footprint& footprint, bool is_attached) {
  if (is_attached) return Form::kGabled;
  const std::uint32_t dice = Draw(0, stable_id(footprint.id), "roof").below(100, 0);
  return dice < 62 ? Form::kGabled : dice < 92 ? Form::kHipped : Form::kHalfHipped;
}

Form untold_form(const map::Footprint& footprint, bool is_attached) {
  if (footprint.is_part) return Form::kFlat;
  const double area = area_m2(footprint.polygon);
  switch (static_cast<BuildingClass>(footprint.building_class)) {
    case BuildingClass::kGarage:
    case BuildingClass::kTower:
    case BuildingClass::kRoof:
    case BuildingClass::kOffice:
      return Form::kFlat;
    case BuildingClass::kHut:
      return area < kLeastShed_m2 || is_attached ? Form::kFlat : Form::kGabled;
    case BuildingClass::kHall:
      return area < kHall_m2 ? Form::kGabled : Form::kFlat;
    case BuildingClass::kBarn:
    case BuildingClass::kChurch:
    case BuildingClass::kGreenhouse:
      return Form::kGabled;
    case BuildingClass::kHouse:
      return house_roof(footprint, is_attached);
    default:
      return is_small(footprint) ? house_roof(footprint, is_attached) : Form::kFlat;
  }
}

// How high the roof is at most.
double room_m(const map::Footprint& footprint, bool is_told) {
  if (!footprint.has_roof_in_height) return 1000;
  const double body_m = footprint.height_m - footprint.min_height_m;
  return is_told ? body_m : std::min(kMostShare * body_m, body_m - kLeastWall_m);
}

bool stands_out(const map::Footprint& footprint, Form form) {
  return (form == Form::kGabled || form == Form::kHipped || form == Form::kHalfHipped) && !footprint.is_part &&
         is_small(footprint);
}

}  // namespace

bool is_small(const map::Footprint& footprint) {
  return footprint.height_m <= kSmall_m && area_m2(footprint.polygon) <= kSmall_m2;
}

roofs::RoofShape plan_roof(const map::Footprint& footprint, const RoofContext& place) {
  roofs::RoofShape roof = footprint.roof;
  const bool is_height_told = roof.height_m > 0;
  if (!footprint.has_roof_shape) {
    roof.form = is_height_told ? Form::kGabled : untold_form(footprint, place.is_attached);
    if (!roof.direction && place.is_attached && roof.form == Form::kGabled) roof.direction = place.street;
    const bool is_hall = footprint.building_class == static_cast<std::uint8_t>(BuildingClass::kHall);
    if (is_hall && roof.angle_deg == 0) roof.angle_deg = kHallPitch_deg;
  }
  const double rise_m = roofs::expected_rise_m(footprint.polygon, roof);
  roof.height_m = snapped(std::min(rise_m, room_m(footprint, is_height_told)));
  if (roof.form == Form::kFlat || roof.height_m < kLeastRise_m) return {};
  roof.angle_deg = roof.levels = 0;
  if (roof.direction) roof.direction = snapped(*roof.direction);
  if (!place.is_attached && stands_out(footprint, roof.form)) roof.overhang_m = kEaves_m;
  return roof;
}

}  // namespace citykiln::buildings
