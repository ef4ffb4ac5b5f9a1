// Chooses the box of a map that is compiled, in degrees, and rejects boxes that would be baked for hours.
#pragma once

#include <optional>

#include "compiler/contract/findings/report.h"
#include "compiler/contract/result.h"
#include "compiler/geometry/box.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// Returns the box that the user asked for or, without one, the map's own box (map_box.h), in degrees.
///
/// A box by the user is clipped to the map's box, and diagnosed kBoxClipped, if one of its sides is longer than
/// kNeverClipped_deg and more than twice as long as the map's. Without a box by the user, stray nodes (nodes that lie
/// far from all others by mistake) are diagnosed kStrayNode. Errors: a box that does not touch the map; the message has
/// a hint if it would with latitude and longitude swapped. O(n log n) in nodes.
/// @param asked  The user's box, if any.
Result<source::LonLatBox> choose_extent(const source::OsmData& osm, const std::optional<source::LonLatBox>& asked,
                                        Report& report);

/// Boxes with sides up to this length are never clipped: about 11 km from south to north.
inline constexpr double kNeverClipped_deg = 0.1;

/// Returns an error for an extent that would be baked for hours without showing much: one with a side over kMaxSide_m,
/// or, if has_box is false, one larger than kSparseFrom_m2 with less than one node per square kilometre.
/// @param extent   In plane metres.
/// @param has_box  True if the user or the map's header states a box.
Result<Done> check_worth_baking(const Box2& extent, const source::OsmData& osm, bool has_box);

/// Longest side of an extent (262 km; arithmetic of ground/ is exact within twice this distance of the origin), and the
/// area from which a density of nodes is required.
inline constexpr double kMaxSide_m = 0x1p18, kSparseFrom_m2 = 2.5e9;

}  // namespace citykiln::map
