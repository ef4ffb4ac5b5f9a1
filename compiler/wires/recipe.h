// Wire recipes: the wires between two supports of a power line or of an electrified track.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/things/generate.h"

namespace citykiln::wires {

using things::WireKind;

/// Ends, sags and heights of wires are multiples of this.
inline constexpr double kWireQuantum_m = 0x1p-7;

/// One wire. It hangs in a parabola: at the share t of its length it is 4 t (1 - t) sag_m below the straight line
/// between its ends.
struct Wire {
  Vec3 from, to;               ///< Plane metres.
  double sag_m = 0;            ///< Not negative.
  std::uint8_t radius_mm = 0;  ///< > 0.
  WireKind kind{};
  bool operator==(const Wire&) const = default;
};

/// All wires between two supports.
struct WireSpan {
  /// The way, with a part that depends on the kind of wires. For a power line it is the index along the way of the node
  /// at the span's end. For wires along an electrified track it is kFirstDerivedPart plus the metres along the way. For
  /// wires across the track (things/contact_masts.h) it is kFirstDerivedPart plus 16 times the metres plus a number
  /// below 16. Several spans may share an id.
  ObjectId id;
  double above_m = 0;       ///< Upper bound of the wires' heights above the ground, in whole metres.
  std::vector<Wire> wires;  ///< At least one.
  bool operator==(const WireSpan&) const = default;
};

/// Returns the place of a wire at the share t of its length, 0 to 1, in plane metres.
inline Vec3 place_on(const Wire& wire, double t) {
  const Vec3 straight = wire.from + (wire.to - wire.from) * t;
  return {straight.x, straight.y, straight.z - 4 * t * (1 - t) * wire.sag_m};
}

/// Returns the place that decides to which tile a span belongs: the middle between the ends of its first wire.
inline Vec2 middle_of(const WireSpan& span) {
  const Wire& first = span.wires.front();
  return (in_plan(first.from) + in_plan(first.to)) * 0.5;
}

}  // namespace citykiln::wires
