#include "compiler/wires/generate.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "compiler/geometry/snap.h"

namespace citykiln::wires {
namespace {

using materials::Material;
using materials::MaterialMesh;

// Share of the tolerance that may go into joining all wires to one; the rest is for its pieces.
constexpr double kJoinedShare = 0.75;

// The corners of a prism around a point of its axis, counter-clockwise as seen along the wire from its beginning.
std::array<Vec3, 3> corners_about(Vec3 at, Vec2 left, double radius_m) {
  // half the square root of 3
  constexpr double kAside = 0.8660254037844386;
  const Vec2 aside = left * (kAside * radius_m);
  return {snapped(at_height(in_plan(at), at.z + radius_m)),
          snapped(at_height(in_plan(at) + aside, at.z - radius_m / 2)),
          snapped(at_height(in_plan(at) - aside, at.z - radius_m / 2))};
}

void add_wire(Mesh& mesh, const Wire& wire, int pieces) {
  const Vec2 left = left_of(unit(in_plan(wire.to) - in_plan(wire.from)));
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (int i = 0; i <= pieces; ++i)
    for (const Vec3 corner :
         corners_about(place_on(wire, static_cast<double>(i) / pieces), left, wire.radius_mm / 1000.0))
      mesh.positions.push_back(corner);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(pieces); ++i)
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t a = first + 3 * i + side, b = first + 3 * i + (side + 1) % 3;
      add_quad(mesh, a, a + 3, b + 3, b);
    }
  const auto last = static_cast<std::uint32_t>(mesh.positions.size()) - 3;
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({last, last + 2, last + 1});
}

// The mean of all wires, and the largest distance of one of them from it.
struct JoinedWire {
  Wire wire;
  double distance_m = 0;
};

JoinedWire joined_wire(const WireSpan& span) {
  JoinedWire joined{span.wires.front(), 0};
  const double share = 1.0 / static_cast<double>(span.wires.size());
  Vec3 from, to;
  double sag_m = 0;
  for (const Wire& wire : span.wires) from = from + wire.from, to = to + wire.to, sag_m += wire.sag_m;
  joined.wire.from = snapped(from * share), joined.wire.to = snapped(to * share), joined.wire.sag_m = sag_m * share;
  for (const Wire& wire : span.wires)
    joined.distance_m =
        std::max(joined.distance_m, std::max(length(wire.from - joined.wire.from), length(wire.to - joined.wire.to)) +
                                        std::abs(wire.sag_m - joined.wire.sag_m));
  return joined;
}

// Conductors are aluminium, cables greased steel.
Material material_of(WireKind kind) {
  return kind == WireKind::kCable ? Material::kPaintedMetal : Material::kMetalCladding;
}

}  // namespace

int pieces_of(double sag_m, double distance_m) {
  assert(sag_m >= 0 && distance_m > 0);
  int pieces = 1;
  while (sag_m > distance_m * pieces * pieces) ++pieces;
  return pieces;
}

GeneratedWires generate(const WireSpan& span, double tolerance_m) {
  assert(tolerance_m > 0 && !span.wires.empty());
  if (span.above_m <= tolerance_m) return {{}, span.above_m};
  GeneratedWires generated;
  generated.meshes.push_back({{}, material_of(span.wires.front().kind), materials::kNoTint, span.id.osm});
  Mesh& mesh = generated.meshes.front().mesh;
  const auto add = [&](const Wire& wire, double distance_m) {
    const int pieces = pieces_of(wire.sag_m, tolerance_m - distance_m);
    generated.error_m = std::max(generated.error_m, distance_m + wire.sag_m / (pieces * pieces));
    add_wire(mesh, wire, pieces);
  };
  const JoinedWire joined = joined_wire(span);
  if (span.wires.size() > 1 && joined.distance_m <= kJoinedShare * tolerance_m)
    add(joined.wire, joined.distance_m);
  else
    for (const Wire& wire : span.wires) add(wire, 0);
  return generated;
}

}  // namespace citykiln::wires
