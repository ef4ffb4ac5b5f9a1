// roof:* as Simple 3D Buildings has them.
#pragma once

#include <optional>

#include "compiler/map/read_context.h"
#include "grammars/roofs/roof_shape.h"

namespace citykiln::map {

struct TaggedRoof {
  bool is_told = false;  ///< Whether the form is.
  roofs::RoofShape shape;
};

/// roof:shape, height, else levels at level_m each, angle, direction, orientation. A shape that no table knows, or a
/// number that cannot be read, is diagnosed kBadTagValue and left out.
TaggedRoof tagged_roof(const ReadContext& context, OsmId id, source::Range tags, double level_m);

}  // namespace citykiln::map
