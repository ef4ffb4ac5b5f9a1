#include "compiler/wires/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/contract/tolerance.h"

namespace citykiln::wires {
namespace {

// Six conductors and an earth wire over 300 m, as on pylons with two arms.
WireSpan pylon_span() {
  WireSpan span{{{OsmType::kWay, 7}, 1}, 40, {}};
  for (const double y : {-9.0, -5.0, 5.0, 9.0})
    span.wires.push_back({{0, y, 25}, {300, y, 31}, 8, 21, WireKind::kConductor});
  for (const double y : {-5.5, 5.5}) span.wires.push_back({{0, y, 31}, {300, y, 37}, 8, 21, WireKind::kConductor});
  span.wires.push_back({{0, 0, 38}, {300, 0, 44}, 6.5, 12, WireKind::kEarthWire});
  return span;
}

double distance_to_wire_m(const Wire& wire, Vec3 p) {
  double least_m = 1e9;
  for (int i = 0; i <= 3000; ++i) least_m = std::min(least_m, length(p - place_on(wire, i / 3000.0)));
  return least_m;
}

// The largest distance of points of the wires from the nearest segment of the axes of the meshes.
double deviation_m(const WireSpan& span, const Mesh& mesh) {
  double largest_m = 0;
  for (const Wire& wire : span.wires)
    for (int i = 0; i <= 300; ++i) {
      const Vec3 p = place_on(wire, i / 300.0);
      double least_m = 1e9;
      for (std::size_t v = 0; v + 3 < mesh.positions.size(); v += 3) {
        const auto axis = [&](std::size_t at) {
          return (mesh.positions[at] + mesh.positions[at + 1] + mesh.positions[at + 2]) * (1.0 / 3);
        };
        const Vec3 a = axis(v), b = axis(v + 3), d = b - a;
        const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
        least_m = std::min(least_m, length(p - (a + d * t)));
      }
      largest_m = std::max(largest_m, least_m);
    }
  return largest_m;
}

TEST(Wires, HangInAParabola) {
  const Wire wire{{0, 0, 20}, {200, 0, 30}, 5, 15, {}};
  EXPECT_EQ(place_on(wire, 0), (Vec3{0, 0, 20}));
  EXPECT_EQ(place_on(wire, 1), (Vec3{200, 0, 30}));
  EXPECT_EQ(place_on(wire, 0.5), (Vec3{100, 0, 20}));
  EXPECT_DOUBLE_EQ(place_on(wire, 0.25).z, 22.5 - 3.75);
}

TEST(Wires, AParabolaIsACatenaryWithinATenthOfAMetre) {
  // y = c (cosh(x / c) - 1) over 350 m, for the tension of lines
  const double c = 1225, half = 175, sag = half * half / (2 * c);
  for (double x = 0; x <= half; x += 5) EXPECT_NEAR(c * (std::cosh(x / c) - 1), sag * x * x / (half * half), 0.1) << x;
}

TEST(Wires, HaveTheFewestPiecesWithinADistance) {
  EXPECT_EQ(pieces_of(0, 0.01), 1);
  EXPECT_EQ(pieces_of(8, 8), 1);
  EXPECT_EQ(pieces_of(8, 2), 2);
  EXPECT_EQ(pieces_of(8, 1.9), 3);
}

TEST(Wires, AreWithinTheErrorThatIsStated) {
  const WireSpan span = pylon_span();
  for (const double tolerance_m : {0.01, 0.1, 0.5, 2.5, 12.5, 20.0}) {
    const GeneratedWires generated = generate(span, tolerance_m);
    ASSERT_EQ(generated.meshes.size(), 1u) << tolerance_m;
    EXPECT_LE(generated.error_m, tolerance_m);
    EXPECT_LE(deviation_m(span, generated.meshes[0].mesh), generated.error_m + 2 * kQuantum_m) << tolerance_m;
  }
}

TEST(Wires, AreClosedBodies) {
  const Mesh mesh = generate(pylon_span(), 0.1).meshes[0].mesh;
  double volume = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 o = mesh.positions[0];
    volume += dot(mesh.positions[t[0]] - o, cross(mesh.positions[t[1]] - o, mesh.positions[t[2]] - o)) / 6;
  }
  // the section of a triangle is 1.299 r²; the vertices are snapped
  const double expected = 1.299 * 300 * (6 * 0.021 * 0.021 + 0.012 * 0.012);
  EXPECT_NEAR(volume, expected, 0.25 * expected);
}

TEST(Wires, AreOneWireWhenTheyAreNearForTheTolerance) {
  const WireSpan span = pylon_span();
  EXPECT_EQ(generate(span, 2.5).meshes[0].mesh.positions.size() % 7, 0u);
  const Mesh joined = generate(span, 20).meshes[0].mesh;
  EXPECT_LE(joined.positions.size(), 12u);
}

TEST(Wires, AreLeftOutAtTheirHeightAboveTheGround) {
  const GeneratedWires generated = generate(pylon_span(), 40);
  EXPECT_TRUE(generated.meshes.empty());
  EXPECT_EQ(generated.error_m, 40);
  EXPECT_FALSE(generate(pylon_span(), 39.9).meshes.empty());
}

TEST(Wires, ReachTheirAttachments) {
  const WireSpan span = pylon_span();
  const Mesh mesh = generate(span, 0.5).meshes[0].mesh;
  for (const Wire& wire : span.wires)
    for (const Vec3 end : {wire.from, wire.to}) {
      double least_m = 1e9;
      for (const Vec3 p : mesh.positions) least_m = std::min(least_m, length(p - end));
      EXPECT_LE(least_m, wire.radius_mm / 1000.0 + 2 * kQuantum_m);
    }
  EXPECT_LT(distance_to_wire_m(span.wires[0], mesh.positions[0]), 0.03);
}

}  // namespace
}  // namespace citykiln::wires
