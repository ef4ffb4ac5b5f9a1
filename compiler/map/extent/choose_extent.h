// Chooses the box of a map that is compiled.
#pragma once

#include <optional>

#include "compiler/contract/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Returns the box that the user asked for, else the map's own (map_box.h), in degrees.
///
/// If a side of the user's box is longer than kFarLarger_deg and than twice the map's, the box is clipped to the map's
/// and diagnosed, kBoxClipped. Without a box by the user, stray nodes are diagnosed, kStrayNode. Errors: a box that
/// does not touch the map; the message has a hint if it would with latitude and longitude swapped. O(n log n) in nodes.
Result<source::LonLatBox> choose_extent(const source::OsmData& osm, const std::optional<source::LonLatBox>& asked,
                                        Report& report);

/// Longer sides of a box are compared with the map's: about 11 km from south to north.
inline constexpr double kFarLarger_deg = 0.1;

/// Returns an error for an extent that would be baked for hours without showing much: with a side over kMaxSide_m, or,
/// if has_box is false, larger than kSparseFrom_m2 with less than one node per square kilometre.
/// @param has_box  True if the user or the map's header states a box.
Result<Done> is_worth_baking(const Box2& extent, const source::OsmData& osm, bool has_box);

/// The longest side of an extent: ground/ computes exactly within twice this distance of the origin.
inline constexpr double kMaxSide_m = 0x1p18, kSparseFrom_m2 = 2.5e9;

}  // namespace citykiln::map
