#include "compiler/buildings/planning/plan_roof.h"

#include <algorithm>
#include <cassert>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/snap.h"
#include "compiler/map/buildings/building_classes.h"
#include "grammars/roofs/expected_rise.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;
using roofs::RoofForm;

// Untagged footprints up to this size and height have pitched roofs.
constexpr double kMaxSmall_m2 = 350, kMaxSmall_m = 20;
// Larger halls have flat roofs.
constexpr double kMaxGabledHall_m2 = 4000, kHallPitch_deg = 9;
// Smaller sheds have flat roofs.
constexpr double kMinGabledShed_m2 = 9;
// Where only the building's height is tagged, the roof has at most half of it and leaves walls of this height.
constexpr double kMaxRoofShare = 0.5, kMinWallUnderRoof_m = 2.25;
// Lower roofs are flat.
constexpr double kMinRise_m = 0.25;
constexpr double kOverhang_m = 0.375;

bool is_small(const map::Footprint& footprint) {
  return footprint.height_m <= kMaxSmall_m && area_m2(footprint.polygon) <= kMaxSmall_m2;
}

RoofForm house_roof(const map::Footprint& footprint, bool is_attached) {
  if (is_attached) return RoofForm::kGabled;
  const std::uint32_t percent = RandomSequence(0, stable_id(footprint.id), "roof").below(100, 0);
  return percent < 62 ? RoofForm::kGabled : percent < 92 ? RoofForm::kHipped : RoofForm::kHalfHipped;
}

RoofForm untagged_form(const map::Footprint& footprint, bool is_attached) {
  if (footprint.is_part || footprint.is_open) return RoofForm::kFlat;
  const double area = area_m2(footprint.polygon);
  switch (static_cast<BuildingClass>(footprint.building_class)) {
    case BuildingClass::kGarage:
    case BuildingClass::kTower:
    case BuildingClass::kRoof:
    case BuildingClass::kShelter:
    case BuildingClass::kSteps:
    case BuildingClass::kColumn:
    case BuildingClass::kOffice:
      return RoofForm::kFlat;
    case BuildingClass::kHut:
      return area < kMinGabledShed_m2 || is_attached ? RoofForm::kFlat : RoofForm::kGabled;
    case BuildingClass::kHall:
      return area < kMaxGabledHall_m2 ? RoofForm::kGabled : RoofForm::kFlat;
    case BuildingClass::kBarn:
    case BuildingClass::kChurch:
    case BuildingClass::kGreenhouse:
      return RoofForm::kGabled;
    case BuildingClass::kHouse:
      return house_roof(footprint, is_attached);
    default:
      return is_small(footprint) ? house_roof(footprint, is_attached) : RoofForm::kFlat;
  }
}

double max_rise_m(const map::Footprint& footprint, bool is_height_tagged) {
  if (!footprint.has_roof_in_height) return 1000;
  const double body_m = footprint.height_m - footprint.min_height_m;
  return is_height_tagged ? body_m : std::min(kMaxRoofShare * body_m, body_m - kMinWallUnderRoof_m);
}

bool has_overhang(const map::Footprint& footprint, RoofForm form) {
  return (form == RoofForm::kGabled || form == RoofForm::kHipped || form == RoofForm::kHalfHipped) &&
         !footprint.is_part && is_small(footprint);
}

}  // namespace

roofs::RoofShape plan_roof(const map::Footprint& footprint, const RoofContext& context) {
  assert(footprint.polygon.outer.size() >= 3);
  roofs::RoofShape roof = footprint.roof;
  const bool is_height_tagged = roof.height_m > 0;
  if (!footprint.has_roof_shape) {
    roof.form = is_height_tagged ? RoofForm::kGabled : untagged_form(footprint, context.is_attached);
    if (!roof.direction && context.is_attached && roof.form == RoofForm::kGabled) roof.direction = context.street;
    const bool is_hall = footprint.building_class == static_cast<std::uint8_t>(BuildingClass::kHall);
    if (is_hall && roof.angle_deg == 0) roof.angle_deg = kHallPitch_deg;
  }
  const double rise_m = roofs::expected_rise_m(footprint.polygon, roof);
  roof.height_m = snapped(std::min(rise_m, max_rise_m(footprint, is_height_tagged)));
  if (roof.form == RoofForm::kFlat || roof.height_m < kMinRise_m) return {};
  roof.angle_deg = roof.levels = 0;
  if (roof.direction) roof.direction = snapped(*roof.direction);
  if (!context.is_attached && has_overhang(footprint, roof.form)) roof.overhang_m = kOverhang_m;
  return roof;
}

}  // namespace citykiln::buildings
