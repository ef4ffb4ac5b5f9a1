// Prop recipes: barriers and mapped lamps.
#pragma once

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/features.h"

namespace citykiln::props {

/// A wall, fence or hedge along a line.
struct Barrier {
  ObjectId id;
  Polyline axis;  ///< Plane metres, snapped.
  map::BarrierKind kind{};
  double height_m = 0, width_m = 0;
  bool operator==(const Barrier&) const = default;
};

/// A mapped street lamp.
struct Lamp {
  ObjectId id;
  Vec2 at;
  double height_m = 0;  ///< 0 if not tagged; the lamp is then as high as the lamps of its street.
  map::LampTags light{};
  bool operator==(const Lamp&) const = default;
};

}  // namespace citykiln::props
