// Decides which box of a map is compiled.
#pragma once

#include <optional>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Returns the box asked for, else the map's (map_box.h), in degrees.
///
/// A box with a side over kFarLarger_deg that is more than twice as long as the map's is clipped to the map's box:
/// kBoxClipped. Nodes outside of the map's box by mistake are diagnosed, kStrayNode. Errors: a box that does not meet
/// the map, with a hint where it would with latitude and longitude swapped. O(n log n) in nodes.
Result<source::LonLatBox> choose_extent(const source::OsmData& osm, const std::optional<source::LonLatBox>& asked,
                                        Report& report);

/// About 11 km from south to north.
inline constexpr double kFarLarger_deg = 0.1;

/// Errors: a region with a side over kMaxSide_m; without a box by the user or in the map's header, one over
/// kSparseFrom_m2 with fewer nodes than square kilometres. Either would be baked for hours without showing much.
/// @param has_box  Whether the user or the map's header states a box.
Result<Done> is_worth_baking(const Box2& region, const source::OsmData& osm, bool has_box);

/// ground/ computes exactly within twice this distance of the origin.
inline constexpr double kMaxSide_m = 0x1p18, kSparseFrom_m2 = 2.5e9;

}  // namespace citykiln::map
