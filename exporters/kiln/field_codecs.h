// Reads and writes fields that many objects of a chunk (the recipes of one tile) have: enumerators, lists, ids, lines,
// profiles. A knot is a vertex of a height profile; a stream is the sequence of values of one property.
//
// Each function both writes and reads: `io` is a Writer or a Reader (chunk_io.h). A reader fails on values that no
// chunk can have.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "compiler/geometry/profile.h"
#include "exporters/kiln/chunk_io.h"

namespace citykiln::exporters {

template <typename Enum>
void enumerator(auto& io, Stream name, Enum& value, Enum count) {
  auto number = static_cast<std::uint64_t>(value);
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads) {
    if (number >= static_cast<std::uint64_t>(count)) io.fail(name), number = 0;
    value = static_cast<Enum>(number);
  }
}

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

void flag(auto& io, Stream name, bool& value) {
  std::uint8_t number = value ? 1 : 0;
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 1) io.fail(name);
  value = number != 0;
}

void id(auto& io, ObjectId& id) {
  enumerator(io, "id type", id.osm.type, static_cast<OsmType>(4));
  io.delta("id", id.osm.id);
  io.number("part", id.part);
}

void points(auto& io, Stream kind, std::vector<Vec2>& axis, std::size_t least) {
  list(io, kind, axis, least, [&](Vec2& p) { io.point(p); });
}

// A multiple of the quantum, as the difference to the stream's last one.
void quanta(auto& io, Stream name, double& value, double quantum) {
  auto count = static_cast<std::int64_t>(std::floor(value / quantum + 0.5));
  io.delta(name, count);
  value = static_cast<double>(count) * quantum;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (std::abs(value) > kMaxCoordinate_m) io.fail(name), value = 0;
}

// A knot: its distance from the knot before, in eighths of a metre, its height and its tilt.
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

void profile(auto& io, Profile& p) {
  std::size_t i = 0;
  list(io, "knots", p, 0, [&](Knot& k) {
    knot(io, k, i > 0 ? &p[i - 1] : nullptr);
    ++i;
  });
}

// A whole number of quarter metres, less than 64 m.
void quarters(auto& io, Stream name, double& value) {
  auto quarters = static_cast<std::uint8_t>(value * 4);
  io.number(name, quarters);
  value = quarters / 4.0;
}

// Several small numbers packed into one as mixed-radix digits. take() returns the least significant one.
struct MixedRadix {
  std::uint64_t number;
  std::uint64_t take(std::uint64_t count) {
    const std::uint64_t taken = number % count;
    number /= count;
    return taken;
  }
};

// A non-negative multiple of 2^-11 m, half a quantum.
void half_steps(auto& io, Stream name, double& value) {
  constexpr double kHalf_m = kQuantum_m / 2;
  auto steps = static_cast<std::uint64_t>(value / kHalf_m);
  io.number(name, steps);
  value = static_cast<double>(steps) * kHalf_m;
}

// Two flags as one number.
void flags(auto& io, Stream name, bool& first, bool& second) {
  std::uint8_t number = static_cast<std::uint8_t>((first ? 1 : 0) + (second ? 2 : 0));
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > 3) io.fail(name);
  first = (number & 1) != 0, second = (number & 2) != 0;
}

}  // namespace citykiln::exporters
