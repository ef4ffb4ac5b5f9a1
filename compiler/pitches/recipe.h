// Recipes of sports fields: where the lines of a pitch are. A pitch is an area where a sport is played; it may have
// several fields side by side, such as tennis courts.
#pragma once

#include <cstdint>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"

namespace citykiln::pitches {

/// Rows of fields.inc. Their order is part of the manifest's format: add at the end.
enum class FieldKind : std::uint8_t {
#define FIELD(name, sports, length, width, space, line, lines, equipment) name,
#include "compiler/pitches/fields.inc"
#undef FIELD
  kCount
};

/// A rectangle with the lines of a sport.
struct Field {
  ObjectId id;  ///< The area's; several fields of an area have the same id.
  FieldKind kind{};
  Vec2 from, to;       ///< The middles of its two ends, plane metres, snapped; different.
  double width_m = 1;  ///< Between its outer edges; a multiple of 2^-10, > 0.
  bool operator==(const Field&) const = default;
};

}  // namespace citykiln::pitches
