#include "compiler/geometry/polygons/overlay.h"

#include <geos_c.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "compiler/geometry/snap.h"

namespace citykiln {
namespace {

// A second opinion: GEOS.
using Shape = std::unique_ptr<GEOSGeometry, decltype([](GEOSGeometry* g) { GEOSGeom_destroy(g); })>;

Shape shape(const Ring& ring) {
  GEOSCoordSequence* points = GEOSCoordSeq_create(static_cast<unsigned>(ring.size() + 1), 2);
  for (unsigned i = 0; i <= ring.size(); ++i)
    GEOSCoordSeq_setXY(points, i, ring[i % ring.size()].x, ring[i % ring.size()].y);
  return Shape(GEOSGeom_createPolygon(GEOSGeom_createLinearRing(points), nullptr, 0));
}

Shape shape(const Polygon& polygon) {
  Shape whole = shape(polygon.outer);
  for (const Ring& hole : polygon.holes) whole.reset(GEOSDifference(whole.get(), shape(hole).get()));
  return whole;
}

double geos_area_m2(const Shape& s) {
  double area = 0;
  GEOSArea(s.get(), &area);
  return area;
}

void keep_silent(const char*, ...) {}

struct Overlay : testing::Test {
  Overlay() { initGEOS(keep_silent, keep_silent); }
  ~Overlay() override { finishGEOS(); }
};

// Convex rings, many of them thin, that share points now and then.
std::vector<Ring> random_rings(std::mt19937& chance, int count) {
  std::vector<Ring> rings;
  const auto coordinate = [&] { return snapped(static_cast<double>(chance() % 40000) / 1000); };
  for (int i = 0; i < count; ++i) {
    Ring ring = {{coordinate(), coordinate()}, {coordinate(), coordinate()}, {coordinate(), coordinate()}};
    if (i > 0 && chance() % 3 == 0) ring[0] = rings.back()[1];
    if (chance() % 4 == 0) ring[2] = snapped(ring[1] + Vec2{0.01, 0.02});
    if (signed_area_m2(ring) < 0) std::swap(ring[0], ring[1]);
    if (signed_area_m2(ring) > 0) rings.push_back(ring);
  }
  return rings;
}

TEST_F(Overlay, GivesEveryOwnerTheAreaNotCoveredByLowerNumbers) {
  std::mt19937 chance(5);
  for (int round = 0; round < 300; ++round) {
    const std::uint32_t owners = 1 + chance() % 5;
    std::vector<OwnedSegment> segments;
    std::vector<Shape> covered(owners);
    for (std::uint32_t owner = 0; owner < owners; ++owner) {
      covered[owner].reset(GEOSGeom_createEmptyPolygon());
      for (const Ring& ring : random_rings(chance, 1 + static_cast<int>(chance() % 4))) {
        add_ring(segments, ring, owner);
        covered[owner].reset(GEOSUnion(covered[owner].get(), shape(ring).get()));
      }
    }
    const auto owned = overlay(segments, owners);
    Shape above(GEOSGeom_createEmptyPolygon());
    for (std::uint32_t owner = 0; owner < owners; ++owner) {
      const Shape expected(GEOSDifference(covered[owner].get(), above.get()));
      double area = 0;
      for (const Polygon& polygon : owned[owner]) area += area_m2(polygon);
      // snapping moves borders by a thousandth of a metre: a few hundred metres of them
      EXPECT_NEAR(area, geos_area_m2(expected), 0.3) << "round " << round << " owner " << owner;
      above.reset(GEOSUnion(above.get(), covered[owner].get()));
    }
  }
}

TEST_F(Overlay, MakesValidPolygonsThatShareNoArea) {
  std::mt19937 chance(6);
  std::size_t count = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint32_t owners = 1 + chance() % 4;
    std::vector<OwnedSegment> segments;
    for (std::uint32_t owner = 0; owner < owners; ++owner)
      for (const Ring& ring : random_rings(chance, 3)) add_ring(segments, ring, owner);
    std::vector<Shape> all;
    for (const auto& polygons : overlay(segments, owners))
      for (const Polygon& polygon : polygons) {
        all.push_back(shape(polygon.outer));
        ASSERT_EQ(GEOSisValid(all.back().get()), 1) << "round " << round;
        all.back() = shape(polygon);
        ASSERT_EQ(GEOSisValid(all.back().get()), 1) << "round " << round;
      }
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_LT(geos_area_m2(Shape(GEOSIntersection(all[i].get(), all[j].get()))), 1e-9) << "round " << round;
    count += all.size();
  }
  EXPECT_GT(count, 200u);
}

TEST_F(Overlay, KeepsAHoleThatTouchesTheRim) {
  std::vector<OwnedSegment> segments;
  add_ring(segments, Ring{{2, 0}, {4, 2}, {0, 2}}, 0);
  add_ring(segments, Ring{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, 1);
  const auto owned = overlay(segments, 2);
  ASSERT_EQ(owned[1].size(), 2u);
  EXPECT_EQ(area_m2(owned[1][0]) + area_m2(owned[1][1]), 28);
  segments.clear();
  add_ring(segments, Ring{{2, 0}, {4, 2}, {1, 2}}, 0);
  add_ring(segments, Ring{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, 1);
  const auto with_hole = overlay(segments, 2);
  ASSERT_EQ(with_hole[1].size(), 1u);
  EXPECT_EQ(with_hole[1][0].holes.size(), 1u);
}

TEST_F(Overlay, IsEmptyForNoSegments) { EXPECT_TRUE(overlay({}, 2)[1].empty()); }

}  // namespace
}  // namespace citykiln
