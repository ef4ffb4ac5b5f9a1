// Reads roof:* tags as in Simple 3D Buildings.
#pragma once

#include <optional>

#include "compiler/map/read_context.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {

struct TaggedRoof {
  bool has_shape = false;  ///< True if roof:shape is tagged.
  roofs::RoofShape shape;
};

/// Returns the roof by roof:shape, roof:height (else roof:levels of level_m each), roof:angle, roof:direction and
/// roof:orientation. Diagnosed and ignored: unknown shapes and unreadable numbers, kBadTagValue.
TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m);

}  // namespace citykiln::map
