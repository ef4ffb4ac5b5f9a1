// Reads roof:* tags as in Simple 3D Buildings.
#pragma once

#include <optional>

#include "compiler/map/read_context.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {

struct TaggedRoof {
  bool has_shape = false;  ///< Whether roof:shape is tagged.
  roofs::RoofShape shape;
};

/// Returns the roof by roof:shape, height (else levels at level_m each), angle, direction and orientation. Diagnosed:
/// kBadTagValue for unknown shapes and unreadable numbers, which are left out.
TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m);

}  // namespace citykiln::map
