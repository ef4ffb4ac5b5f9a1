#include "compiler/ground/mesh/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/geometry/snap.h"
#include "compiler/ground/cover/partition.h"
#include "compiler/ground/grading/grading_lines.h"
#include "tests/compiler/ground/mesh/made_references.h"

namespace citykiln::ground {
namespace {

constexpr Box2 kReferenceCell{{-128, 384}, {0, 512}};
constexpr HeightLayer kLayer = HeightLayer::kCarriageway;

Vec2 place_of(const Reference& r, std::uint32_t v) { return plane_point(r.triangulation.vertices()[v]); }
double height_of(const Reference& r, std::uint32_t v) { return r.heights[v][static_cast<std::size_t>(kLayer)]; }

// By definition: looks at every face.
double height_by_all_faces(const Reference& r, Vec2 p) {
  double best_inside = -1e300, z = 0;
  for (const DelaunayFace& f : r.triangulation.faces()) {
    const Vec2 a = place_of(r, f.vertices[0]), u = place_of(r, f.vertices[1]) - a, v = place_of(r, f.vertices[2]) - a;
    const double s = cross(p - a, v) / cross(u, v), t = cross(u, p - a) / cross(u, v);
    const double inside = std::min({s, t, 1 - s - t});
    if (inside <= best_inside) continue;
    best_inside = inside;
    const double h = height_of(r, f.vertices[0]);
    z = h + s * (height_of(r, f.vertices[1]) - h) + t * (height_of(r, f.vertices[2]) - h);
  }
  return z;
}

// The largest error along an edge, by all edges and all vertices of the reference.
double worst_by_all_edges(const Reference& r, Vec3 a, Vec3 b) {
  double worst = 0;
  const Vec2 along = in_plan(b - a);
  const auto consider = [&](Vec2 p, double z) {
    const double t = dot(p - in_plan(a), along) / dot(along, along);
    if (t > 0 && t < 1) worst = std::max(worst, std::abs(a.z + t * (b.z - a.z) - z));
  };
  const auto& vertices = r.triangulation.vertices();
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (turn(grid_point(in_plan(a)), grid_point(in_plan(b)), vertices[v]) == 0)
      consider(place_of(r, v), height_of(r, v));
  for (const DelaunayFace& f : r.triangulation.faces())
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t p = f.vertices[i], q = f.vertices[(i + 1) % 3];
      const Vec2 edge = place_of(r, q) - place_of(r, p);
      const double sides = cross(along, edge);
      if (sides == 0) continue;
      const double s = cross(along, in_plan(a) - place_of(r, p)) / sides;
      const double t = cross(edge, in_plan(a) - place_of(r, p)) / sides;
      if (s < 0 || s > 1 || t <= 0 || t >= 1) continue;
      const double z = height_of(r, p) + s * (height_of(r, q) - height_of(r, p));
      worst = std::max(worst, std::abs(a.z + t * (b.z - a.z) - z));
    }
  return worst;
}

// Random ends of mesh edges: vertices of the reference, points on its edges, on grid lines, on the cell's border,
// anywhere.
Vec3 random_end(const Reference& r, const RandomSequence& draw, std::uint32_t i) {
  const std::uint32_t v = draw.below(static_cast<std::uint32_t>(r.heights.size()), 8 * i);
  const Vec2 anywhere{draw.between(r.cell.min.x, r.cell.max.x, 8 * i + 1),
                      draw.between(r.cell.min.y, r.cell.max.y, 8 * i + 2)};
  const double z = draw.between(0, 20, 8 * i + 3);
  switch (draw.below(4, 8 * i + 4)) {
    case 0:
      return at_height(place_of(r, v), z);
    case 1:
      return at_height({std::floor(anywhere.x / 8) * 8, std::floor(anywhere.y / 4) * 4}, z);
    case 2:
      return at_height({snapped(anywhere.x), draw.unit(8 * i + 5) < 0.5 ? r.cell.min.y : r.cell.max.y}, z);
    default:
      return at_height(snapped(anywhere), z);
  }
}

TEST(Reference, HeightIsExactAtVertices) {
  const Reference r = random_reference(kReferenceCell, 1, 60, 30);
  ASSERT_FALSE(r.heights.empty());
  for (std::uint32_t v = 0; v < r.heights.size(); ++v)
    EXPECT_EQ(height_m_at(r, place_of(r, v), kLayer), height_of(r, v));
}

TEST(Reference, HeightIsThatOfTheFace) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Reference r = random_reference(kReferenceCell, seed, 40, 30);
    const RandomSequence draw(seed, StableId{9}, "places");
    for (std::uint32_t i = 0; i < 2000; ++i) {
      const Vec2 p{draw.between(-128, 0, 2 * i), draw.between(384, 512, 2 * i + 1)};
      // a face may be a grid step thin: a place is known to 2^-31 m
      EXPECT_NEAR(height_m_at(r, p, kLayer), height_by_all_faces(r, p), 1e-4);
    }
  }
}

TEST(Reference, HeightsOfAPlaceAreThoseOfItsLayersToTheBit) {
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const Reference r = random_reference(kReferenceCell, seed, 40, 30);
    const RandomSequence draw(seed, StableId{12}, "places");
    for (std::uint32_t i = 0; i < 500; ++i) {
      const Vec2 p = in_plan(random_end(r, draw, i));
      const Heights heights = heights_at(r, place_at(r, p));
      for (std::size_t layer = 0; layer < heights.size(); ++layer)
        EXPECT_EQ(heights[layer], height_m_at(r, p, static_cast<HeightLayer>(layer)));
    }
  }
}

TEST(Reference, OutsideItIsTheNearestBorder) {
  const Reference r = random_reference(kReferenceCell, 1, 20, 30);
  EXPECT_EQ(height_m_at(r, {-500, 400}, kLayer), height_m_at(r, {-128, 400}, kLayer));
  EXPECT_EQ(height_m_at(r, {9, 1e9}, kLayer), height_m_at(r, {0, 512}, kLayer));
}

TEST(Reference, WorstOnEdgeIsThatOfAllCrossings) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Reference r = random_reference(kReferenceCell, seed, 10 + 5 * static_cast<int>(seed), 30);
    const RandomSequence draw(seed, StableId{10}, "edges");
    for (std::uint32_t i = 0; i < 400; i += 2) {
      const Vec3 a = random_end(r, draw, i), b = random_end(r, draw, i + 1);
      if (in_plan(a) == in_plan(b)) continue;
      EXPECT_NEAR(worst_on_edge(r, a, b, kLayer).error_m, worst_by_all_edges(r, a, b), 1e-6) << seed << ' ' << i;
    }
  }
}

TEST(Reference, NoSampleAlongAnEdgeIsWorse) {
  const Reference r = random_reference(kReferenceCell, 3, 50, 30);
  const RandomSequence draw(3, StableId{11}, "edges");
  for (std::uint32_t i = 0; i < 100; i += 2) {
    Vec3 a = random_end(r, draw, i), b = random_end(r, draw, i + 1);
    a.z = height_m_at(r, in_plan(a), kLayer), b.z = height_m_at(r, in_plan(b), kLayer);
    const WorstPoint worst = worst_on_edge(r, a, b, kLayer);
    for (int k = 1; k < 500; ++k) {
      const Vec3 p = a + (b - a) * (k / 500.0);
      EXPECT_LE(std::abs(p.z - height_m_at(r, in_plan(p), kLayer)), worst.error_m + 1e-4);
    }
  }
}

TEST(Reference, AnEdgeOfItsOwnHasNoError) {
  const Reference r = random_reference(kReferenceCell, 4, 60, 30);
  const auto at = [&](std::uint32_t v) { return at_height(place_of(r, v), height_of(r, v)); };
  ASSERT_FALSE(r.triangulation.faces().empty());
  for (const DelaunayFace& f : r.triangulation.faces())
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(worst_on_edge(r, at(f.vertices[i]), at(f.vertices[(i + 1) % 3]), kLayer).error_m, 0);
}

TEST(Reference, BothWaysAlongAnEdgeAreTheSame) {
  const Reference r = random_reference(kReferenceCell, 5, 60, 30);
  const RandomSequence draw(5, StableId{12}, "edges");
  double largest_m = 0;
  for (std::uint32_t i = 0; i < 400; i += 2) {
    const Vec3 a = random_end(r, draw, i), b = random_end(r, draw, i + 1);
    const WorstPoint there = worst_on_edge(r, a, b, kLayer), back = worst_on_edge(r, b, a, kLayer);
    EXPECT_EQ(there.error_m, back.error_m);
    EXPECT_EQ(there.at, back.at);
    largest_m = std::max(largest_m, there.error_m);
  }
  EXPECT_GT(largest_m, 0);
}

// Two cells that share a border, with the same vertices on it and different ones inside.
TEST(Reference, OnACommonBorderBothCellsFindTheSame) {
  const Box2 west = kReferenceCell, east{{0, 384}, {128, 512}};
  std::vector<OwnedSegment> across;
  const RandomSequence draw(6, StableId{13}, "across");
  for (std::uint32_t i = 0; i < 40; ++i)
    across.push_back(
        {grid_point({-64, draw.between(384, 512, 2 * i)}), grid_point({64, draw.between(384, 512, 2 * i + 1)}), 0, 1});
  std::vector<OwnedSegment> more = across;
  more.push_back({grid_point({70, 400}), grid_point({110, 480}), 0, 1});
  const auto reference = [&](std::span<const OwnedSegment> segments, const Box2& cell) {
    const Arrangement arrangement = arrange(segments, {}, cell);
    std::vector<Heights> heights;
    for (const GridPoint p : arrangement.vertices) {
      heights.emplace_back();
      heights.back().fill(static_cast<double>((p.x * 7919 + p.y * 104729) % 4096) / 128);
    }
    return reference_of(triangulated(arrangement), std::move(heights), cell);
  };
  const Reference left = reference(across, west), right = reference(more, east);
  double largest_m = 0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Vec3 a{0, snapped(draw.between(384, 512, 1000 + 2 * i)), 3},
        b{0, snapped(draw.between(384, 512, 1001 + 2 * i)), 5};
    const WorstPoint one = worst_on_edge(left, a, b, kLayer), other = worst_on_edge(right, a, b, kLayer);
    EXPECT_EQ(one.error_m, other.error_m);
    EXPECT_EQ(one.at, other.at);
    EXPECT_EQ(height_m_at(left, in_plan(a), kLayer), height_m_at(right, in_plan(a), kLayer));
    EXPECT_TRUE(one.error_m == 0 || one.at.x == 0);
    largest_m = std::max(largest_m, one.error_m);
  }
  EXPECT_GT(largest_m, 0);
}

WorstPoint worst_for(const Reference& reference, Vec3 a, Vec3 b) {
  const auto end = [&](Vec3 p) { return EdgeEnd{p, place_at(reference, in_plan(p)).face}; };
  return worst_on_shared_edge(reference, end(a), end(b), kLayer);
}

// Bit for bit: a graded and an ungraded cell share their border.
TEST(Reference, AlongBordersTheTerrainItselfFindsWhatItsTriangulationFinds) {
  for (const Vec2 step_m : {Vec2{16, 16}, {17, 11}, {9.5, 15}, {60, 88}, {92, 13}}) {
    const RandomSequence draw(8, StableId{15}, "edges");
    map::Heightfield field{step_m * -8.0, step_m, 24, 24, {}, 0};
    for (std::uint32_t i = 0; i < 24 * 24; ++i)
      field.heights.push_back(static_cast<std::int32_t>(draw.between(0, 3000, 5000 + i)));
    const Box2 cell{{-37, -20}, {91, 108}};
    const GradedTerrain graded{map::Heightfield(field)};
    GradedHeights cache(graded);
    Partition all = partition_all_rings({}, grading_lines(cache, cell), {}, cell);
    std::vector<Heights> heights;
    for (const GridPoint p : all.triangulation.vertices()) heights.push_back(heights_at(graded, plane_point(p)));
    const Reference triangulated = reference_of(std::move(all.triangulation), std::move(heights), cell);
    const Reference bare = reference_of(field, cell);
    for (std::uint32_t i = 0; i < 4000; i += 4) {
      const double from = snapped(draw.between(0, 128, i)), to = snapped(draw.between(0, 128, i + 1));
      if (from == to) continue;
      const double across = i % 8 == 0 ? 0 : 128, z = draw.between(0, 40, i + 2);
      const auto end = [&](double along, double z_m) {
        return at_height(cell.min + (i % 16 < 8 ? Vec2{across, along} : Vec2{along, across}), z_m);
      };
      const WorstPoint one = worst_for(triangulated, end(from, z), end(to, 7));
      const WorstPoint other = worst_for(bare, end(from, z), end(to, 7));
      EXPECT_EQ(one.error_m, other.error_m);
      EXPECT_EQ(one.at, other.at);
      // and no farther off the terrain than its diagonals were moved, on slopes below 6 to 1
      const double most_m = 0x1p-11 * (6 + std::abs(z - 7) / std::abs(to - from));
      EXPECT_NEAR(other.error_m, worst_on_edge(field, end(from, z), end(to, 7)).error_m, most_m);
    }
  }
}

TEST(Reference, WorstInsideIsThatOfAllVertices) {
  const Reference r = random_reference(kReferenceCell, 7, 60, 30);
  const RandomSequence draw(7, StableId{14}, "triangles");
  double largest_m = 0;
  for (std::uint32_t i = 0; i < 900; i += 3) {
    std::array<Vec3, 3> corners = {random_end(r, draw, i), random_end(r, draw, i + 1), random_end(r, draw, i + 2)};
    const double area = cross(in_plan(corners[1] - corners[0]), in_plan(corners[2] - corners[0]));
    if (area == 0) continue;
    if (area < 0) std::swap(corners[1], corners[2]);
    double worst = 0;
    for (std::uint32_t v = 0; v < r.heights.size(); ++v) {
      std::array<double, 3> weights;
      for (int k = 0; k < 3; ++k)
        weights[k] =
            cross(in_plan(corners[(k + 2) % 3] - corners[(k + 1) % 3]), place_of(r, v) - in_plan(corners[(k + 1) % 3]));
      if (*std::ranges::min_element(weights) <= 0) continue;
      double z = 0;
      for (int k = 0; k < 3; ++k) z += weights[k] / std::abs(area) * corners[k].z;
      worst = std::max(worst, std::abs(z - height_of(r, v)));
    }
    EXPECT_NEAR(worst_inside(r, corners, kLayer).error_m, worst, 1e-9);
    largest_m = std::max(largest_m, worst);
  }
  EXPECT_GT(largest_m, 0);
}

TEST(Reference, LayersAreTheirOwn) {
  const Reference r = random_reference(kReferenceCell, 8, 20, 30);
  const Vec2 p = place_of(r, 5);
  for (std::size_t layer = 0; layer < r.heights[5].size(); ++layer)
    EXPECT_EQ(height_m_at(r, p, static_cast<HeightLayer>(layer)), r.heights[5][layer]);
}

TEST(Reference, NearestVertexIsTheNearest) {
  const Reference r = random_reference(kReferenceCell, 9, 40, 30);
  const RandomSequence draw(9, StableId{15}, "places");
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec2 p = snapped(Vec2{draw.between(-140, 10, 2 * i), draw.between(370, 520, 2 * i + 1)});
    double least = 1e300;
    for (std::uint32_t v = 0; v < r.heights.size(); ++v) least = std::min(least, distance(p, place_of(r, v)));
    EXPECT_EQ(distance(p, nearest_vertex(r, p)), least);
  }
}

TEST(Reference, OfAGridItAgreesWithTheField) {
  map::Heightfield field{{-64, -64}, {16, 16}, 9, 17, {}};
  const RandomSequence draw(1, StableId{2}, "heights");
  for (int i = 0; i < field.columns * field.rows; ++i)
    field.heights.push_back(static_cast<std::int32_t>(draw.unit(static_cast<std::uint32_t>(i)) * 1280));
  const Reference r = reference_of_field(field);
  const RandomSequence ends(1, StableId{16}, "ends");
  for (std::uint32_t i = 0; i < 3000; i += 3) {
    std::array<Vec3, 3> corners = {random_end(r, ends, i), random_end(r, ends, i + 1), random_end(r, ends, i + 2)};
    EXPECT_NEAR(height_m_at(r, in_plan(corners[0]), kLayer), map::height_m_at(field, in_plan(corners[0])), 1e-9);
    if (in_plan(corners[0]) == in_plan(corners[1])) continue;
    EXPECT_NEAR(worst_on_edge(r, corners[0], corners[1], kLayer).error_m,
                worst_on_edge(field, corners[0], corners[1]).error_m, 1e-9);
    const double area = cross(in_plan(corners[1] - corners[0]), in_plan(corners[2] - corners[0]));
    if (area == 0) continue;
    if (area < 0) std::swap(corners[1], corners[2]);
    // the field's version includes vertices on the triangle's edges; here they belong to the edges
    double of_field = worst_inside(field, corners).error_m, ours = worst_inside(r, corners, kLayer).error_m;
    for (int k = 0; k < 3; ++k) {
      of_field = std::max(of_field, worst_on_edge(field, corners[k], corners[(k + 1) % 3]).error_m);
      ours = std::max(ours, worst_on_edge(r, corners[k], corners[(k + 1) % 3], kLayer).error_m);
      const double at_corner = std::abs(corners[k].z - map::height_m_at(field, in_plan(corners[k])));
      of_field = std::max(of_field, at_corner);
      ours = std::max(ours, at_corner);
    }
    EXPECT_NEAR(ours, of_field, 1e-9);
  }
}

}  // namespace
}  // namespace citykiln::ground
