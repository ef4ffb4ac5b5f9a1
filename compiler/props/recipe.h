// Prop recipes: barriers and mapped lamps.
#pragma once

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"

namespace citykiln::props {

/// A barrier that is built. Its axis is cut 4 m outside of the extent.
using Barrier = map::Barrier;

/// A mapped street lamp.
struct Lamp {
  ObjectId id;
  Vec2 at;
  double height_m = 0;  ///< 0 if not tagged; the lamp is then as high as the lamps of its street.
  map::LampTags light{};
  bool operator==(const Lamp&) const = default;
};

}  // namespace citykiln::props
