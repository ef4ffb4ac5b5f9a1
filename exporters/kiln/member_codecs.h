// Reads and writes members that many objects of a chunk (the recipes of one tile) have: enumerators, lists, ids, lines,
// profiles. A knot is a vertex of a height profile; a stream is the sequence of values of one property.
//
// Each function both writes and reads: `io` is a Writer or a Reader (chunk_io.h). A Writer reads the value from the
// caller's variable, a Reader sets it. Functions that round also set the variable of a Writer to the rounded value. A
// Reader fails on values that no chunk can have: io.fail() notes the name of the stream.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "compiler/geometry/profile.h"
#include "exporters/kiln/chunk_io.h"

namespace citykiln::exporters {

/// An enumerator, as its number.
/// @param count  The number of enumerators; a Reader fails on numbers from there on.
template <typename Enum>
void enumerator(auto& io, Stream name, Enum& value, Enum count) {
  auto number = static_cast<std::uint64_t>(value);
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number >= static_cast<std::uint64_t>(count)) io.fail(name), number = 0;
    value = static_cast<Enum>(number);
  }
}

/// A list of objects: its length, then each object by each(object).
/// @param least  The smallest length; a Reader fails on shorter lists.
template <typename Io, typename Object, typename Each>
void list(Io& io, Stream name, std::vector<Object>& objects, std::size_t least, Each each) {
  const std::size_t size = io.count(name, objects.size());
  if constexpr (Io::kReads) {
    if (size < least) return io.fail(name);
    // memory grows with the objects that are read, not with the stated count
    objects.reserve(std::min(size, kMaxReserve));
    for (std::size_t i = 0; i < size && io.wrong.empty(); ++i) each(objects.emplace_back());
  } else {
    for (Object& object : objects) each(object);
  }
}

/// A bool, as 0 or 1.
void flag(auto& io, Stream name, bool& value) {
  std::uint8_t number = value ? 1 : 0;
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 1) io.fail(name);
  value = number != 0;
}

/// The id of an object: type of the OSM element, its number as the difference to the stream's last one, and the part.
void id(auto& io, ObjectId& id) {
  enumerator(io, "id type", id.osm.type, static_cast<OsmType>(kOsmTypeCount));
  io.delta("id", id.osm.id);
  io.number("part", id.part);
}

/// The points of a line or ring.
/// @param kind   The stream with the number of points.
/// @param least  The smallest number of points.
void points(auto& io, Stream kind, std::vector<Vec2>& axis, std::size_t least) {
  list(io, kind, axis, least, [&](Vec2& p) { io.point(p); });
}

/// A number, rounded to a multiple of `quantum`. The multiple is written as the difference to the stream's last one.
void quanta(auto& io, Stream name, double& value, double quantum) {
  auto count = static_cast<std::int64_t>(std::floor(value / quantum + 0.5));
  io.delta(name, count);
  value = static_cast<double>(count) * quantum;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (std::abs(value) > kMaxCoordinate_m) io.fail(name), value = 0;
}

/// A knot of a profile: its distance from the knot before, in eighths of a metre, its height and its tilt.
void knot(auto& io, Knot& k, const Knot* before) {
  const double from_m = before ? before->at_m : 0;
  auto steps = static_cast<std::uint64_t>((k.at_m - from_m) * 8);
  io.number("knot steps", steps);
  k.at_m = from_m + static_cast<double>(steps) / 8;
  quanta(io, "knot height", k.z_m, kProfileQuantum_m);
  quanta(io, "knot tilt", k.tilt, kTiltQuantum);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if ((before && steps == 0) || k.at_m > kMaxCoordinate_m) io.fail("knot steps");
}

/// A height profile, as a list of knots.
void profile(auto& io, Profile& p) {
  std::size_t i = 0;
  list(io, "knots", p, 0, [&](Knot& k) {
    knot(io, k, i > 0 ? &p[i - 1] : nullptr);
    ++i;
  });
}

/// A length of less than 64 m, rounded down to quarters of a metre.
void quarters(auto& io, Stream name, double& value) {
  auto quarters = static_cast<std::uint8_t>(value * 4);
  io.number(name, quarters);
  value = quarters / 4.0;
}

/// Several small numbers in one, as digits of a number whose places have different bases.
struct MixedRadix {
  std::uint64_t number;  ///< The digits that remain.
  /// Removes the least significant digit and returns it.
  /// @param count  The base of its place.
  std::uint64_t take(std::uint64_t count) {
    const std::uint64_t taken = number % count;
    number /= count;
    return taken;
  }
};

/// A length of at least 0, rounded down to a multiple of 2^-11 m, half of kQuantum_m.
void half_steps(auto& io, Stream name, double& value) {
  constexpr double kHalf_m = kQuantum_m / 2;
  auto steps = static_cast<std::uint64_t>(value / kHalf_m);
  io.number(name, steps);
  value = static_cast<double>(steps) * kHalf_m;
}

/// Reads or writes two bools as one number, 0 to 3.
void flags(auto& io, Stream name, bool& first, bool& second) {
  std::uint8_t number = static_cast<std::uint8_t>((first ? 1 : 0) + (second ? 2 : 0));
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 3) io.fail(name);
  first = (number & 1) != 0, second = (number & 2) != 0;
}

}  // namespace citykiln::exporters
