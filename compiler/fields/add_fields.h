// Divides the farmland of a map into fields with crops, and adds the hedges and walls between them
// and beside roads. Fields are areas and barriers, as if they were mapped.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/fields/divide_land.h"
#include "compiler/lots/lot_inputs.h"
#include "compiler/map/features.h"
#include "compiler/map/plane/heightfield.h"

namespace citykiln::fields {

/// The inputs of fields besides the features. They refer to data that must outlive them.
struct FieldInputs {
  std::span<const roads::Road> roads;          ///< Planned roads with their pavements.
  std::span<const roads::Junction> junctions;  ///< The junctions of these roads.
  const map::Heightfield& heights;
  const RuleAt& rule_at;              ///< By plane metres.
  const lots::ClimateAt& climate_at;  ///< By plane metres.
  const std::function<map::CountryGroup(Vec2)>& country_at;
  Assumptions assumed = kAllAssumptions;  ///< kFields, and kRoadsides for hedges beside roads.
  std::uint64_t seed = 0;
  int threads = 0;  ///< 0: all processors.
};

/// The areas and barriers of a map with those of fields, each list sorted by id.
struct Fields {
  std::vector<map::AreaFeature> areas;
  std::vector<map::Barrier> barriers;
};

/// Returns the features with the areas and barriers of `fields` in place of their own. The result
/// refers to `fields`, which must outlive it unchanged.
map::FeatureView seen_with(map::FeatureView features, const Fields& fields);

/// Returns all areas and barriers of the map, with fields (kFields) and hedges beside roads
/// (lane_hedges.h, kRoadsides).
///
/// Farmland and meadows are divided (divide_land.h), except where tags name their plants. The area
/// itself stays, with its id and a crop, and lies below its fields: their area_m2 is its area_m2
/// less 1 m², and smaller areas lie above larger ones. All that is mapped more finely lies above
/// the fields. Unmapped land near farmland gets fields too (open_land.h), where most of it is no
/// steeper than 15 % and not mapped.
///
/// Each field has a crop (crops.inc), or is a pasture or hay meadow, and the row_heading of its
/// longer side. Fields of meadows and of unmapped land are larger than FieldRule::area_m2, those on
/// slopes of more than 15 % smaller. Hedges or walls stand on borders between fields that FieldRule
/// gives one, on places where BarrierPlaces::is_free().
///
/// Fields and what stands on their borders have ids of field_id(), hedges beside roads those of
/// roadside_id() (contract/derived_id.h). Mapped areas that are divided are counted in the report
/// as Assumption::kFields; fields of unmapped land are not. The result does not depend on the order
/// of the features. Cost: that of divide() for each area and square, and O(length of hedges).
Fields with_fields(const map::FeatureView& features, const FieldInputs& inputs, Report& report);

/// The distance in metres of hedges and walls on borders of fields from the edges of ways,
/// buildings, water, mapped barriers and trees.
inline constexpr double kClear_m = 2.5;

}  // namespace citykiln::fields
