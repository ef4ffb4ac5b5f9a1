// Adds the fields of a map to its features, as tags would give them: areas with a crop, and the hedges and walls
// between them.
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

/// The inputs of fields besides the features. Refers to its parts, which must outlive it.
struct FieldInputs {
  std::span<const roads::Road> roads;          ///< Planned roads with their pavements.
  std::span<const roads::Junction> junctions;  ///< The junctions of these roads.
  const map::Heightfield& heights;
  const RuleAt& rule_at;
  const lots::ClimateAt& climate_at;
  const std::function<map::CountryGroup(Vec2)>& country_at;
  Assumptions assumed = kAllAssumptions;  ///< kFields, and kRoadsides for hedges beside roads.
  std::uint64_t seed = 0;
  int threads = 0;  ///< 0: all processors.
};

/// The lists of a map to which fields add, each sorted by id.
struct Fields {
  std::vector<map::AreaFeature> areas;
  std::vector<map::Barrier> barriers;
};

/// Returns the features with the lists of `fields` in place of theirs. The result refers to `fields`, which must
/// outlive it unchanged.
map::FeatureView seen_with(map::FeatureView features, const Fields& fields);

/// Returns the features with farmland and meadows divided into fields, and open land (open_land.h). Land whose tags
/// name its plants stays as it is. Roads get hedges (lane_hedges.h).
///
/// The area itself becomes a field, with the crop of the land that is in no other field. If it is divided
/// (divide_land.h), the fields are areas on top of it, by its area less 1 m²: all that is mapped more finely lies above
/// them. Each has a crop (crops.inc) or is a part of a meadow, and the heading of its longer side. Hedges or walls
/// stand on borders where that is usual, but not within kClear_m of ways, buildings, water and mapped barriers and
/// trees, nor on land that is mapped on top. All have ids of field_id() (contract/derived_id.h). Areas that become
/// fields are counted in the report as assumed. The result does not depend on the order of features. Cannot fail.
/// Cost: that of divide() for each area, and O(length of hedges).
Fields with_fields(const map::FeatureView& features, const FieldInputs& inputs, Report& report);

/// The distance of assumed hedges and walls from ways, buildings, mapped barriers and trees.
inline constexpr double kClear_m = 2.5;

}  // namespace citykiln::fields
