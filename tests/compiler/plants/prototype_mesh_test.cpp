#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "compiler/geometry/snap.h"
#include "compiler/plants/expand.h"

namespace citykiln::plants {
namespace {

constexpr Prototype kAll[] = {{Species::kLime, 0}, {Species::kSpruce, 0}};

// Tolerances that ask for each detail of a tree 1 m tall, full first.
constexpr double kDetails[] = {0.001, 0.08, 0.5};

using Corners = std::array<Vec3, 3>;

// Ericson, "Real-Time Collision Detection", 5.1.5.
Vec3 nearest_on(const Corners& t, Vec3 p) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0], bp = p - t[1], cp = p - t[2];
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  if (d1 <= 0 && d2 <= 0) return t[0];
  if (d3 >= 0 && d4 <= d3) return t[1];
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return t[0] + ab * (d1 / (d1 - d3));
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return t[0] + ac * (d2 / (d2 - d6));
  if (va <= 0 && d4 >= d3 && d5 >= d6) return t[1] + (t[2] - t[1]) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
  return t[0] + ab * (vb / (va + vb + vc)) + ac * (vc / (va + vb + vc));
}

std::vector<Corners> triangles_of(const PrototypeMesh& tree) {
  std::vector<Corners> all;
  for (const auto& dressed : tree.meshes)
    for (const auto& [a, b, c] : dressed.mesh.triangles)
      all.push_back({dressed.mesh.positions[a], dressed.mesh.positions[b], dressed.mesh.positions[c]});
  return all;
}

// No point of the piece is farther from the shape: the distance to one triangle is convex, so its corners tell. Cut in
// four `times` times for a closer bound.
double bound_on(const Corners& piece, const std::vector<Corners>& shape, int times) {
  if (times > 0) {
    const Vec3 ab = (piece[0] + piece[1]) * 0.5, bc = (piece[1] + piece[2]) * 0.5, ca = (piece[2] + piece[0]) * 0.5;
    return std::max({bound_on({piece[0], ab, ca}, shape, times - 1), bound_on({ab, piece[1], bc}, shape, times - 1),
                     bound_on({ca, bc, piece[2]}, shape, times - 1), bound_on({ab, bc, ca}, shape, times - 1)});
  }
  double best = 10;
  for (const Corners& t : shape) {
    double worst = 0;
    for (const Vec3 p : piece) worst = std::max(worst, length(p - nearest_on(t, p)));
    best = std::min(best, worst);
  }
  return best;
}

double bound_on(const std::vector<Corners>& from, const std::vector<Corners>& to) {
  double worst = 0;
  for (const Corners& piece : from) worst = std::max(worst, bound_on(piece, to, 2));
  return worst;
}

TEST(PrototypeMesh, DeviatesByNoMoreThanItsError) {
  for (const Prototype prototype : kAll) {
    const auto full = triangles_of(prototype_mesh(prototype, 1, kDetails[0]));
    for (const double tolerance : {kDetails[1], kDetails[2]}) {
      const PrototypeMesh cut = prototype_mesh(prototype, 1, tolerance);
      const double there = bound_on(full, triangles_of(cut)), back = bound_on(triangles_of(cut), full);
      EXPECT_LE(std::max(there, back), cut.error_per_m) << there << " there, " << back << " back";
      EXPECT_LE(cut.error_per_m, tolerance);
    }
  }
}

TEST(PrototypeMesh, TakesFewerTrianglesTheCoarserItMayBe) {
  for (const Prototype prototype : kAll) {
    std::vector<std::size_t> counts;
    for (const double tolerance : kDetails)
      counts.push_back(triangles_of(prototype_mesh(prototype, 1, tolerance)).size());
    EXPECT_GE(counts[0], 100u);
    EXPECT_LE(counts[0], 350u);
    EXPECT_GE(counts[0], 2 * counts[1]);
    EXPECT_GE(counts[1], 2 * counts[2]);
  }
}

TEST(PrototypeMesh, KeepsTheTallestTreeWithinEachLevelOfTheLadder) {
  for (const Prototype prototype : kAll)
    for (const double tolerance : kDefaultLadder_m) {
      const PrototypeMesh tree = prototype_mesh(prototype, kTallestTree_m, tolerance);
      EXPECT_FALSE(tree.meshes.empty());
      EXPECT_LE(tree.error_per_m * kTallestTree_m, tolerance);
    }
  // 2.5 m is where cutting begins to pay
  EXPECT_GT(prototype_mesh(kAll[0], kTallestTree_m, 2.5).error_per_m, 0);
}

TEST(PrototypeMesh, DropsTreesLowerThanTheTolerance) {
  const PrototypeMesh dropped = prototype_mesh(kAll[0], 10, 12.5);
  EXPECT_TRUE(dropped.meshes.empty());
  EXPECT_EQ(dropped.error_per_m, 1);
}

TEST(PrototypeMesh, IsOneMetreTallOnItsFootAndOnTheGrid) {
  for (const Prototype prototype : kAll) {
    double top = 0;
    for (const auto& dressed : prototype_mesh(prototype, 1, kDetails[0]).meshes) {
      ASSERT_EQ(dressed.mesh.normals.size(), dressed.mesh.positions.size());
      for (const Vec3 n : dressed.mesh.normals) EXPECT_NEAR(length(n), 1, 1e-12);
      for (const Vec3 p : dressed.mesh.positions) {
        EXPECT_EQ(p, snapped(p));
        EXPECT_LT(length(in_plan(p)), 0.45);
        top = std::max(top, p.z);
      }
    }
    EXPECT_NEAR(top, 1, 0.04);
  }
}

TEST(PrototypeMesh, ClosesItsCrowns) {
  for (const Prototype prototype : kAll)
    for (const double tolerance : kDetails) {
      const PrototypeMesh tree = prototype_mesh(prototype, 1, tolerance);
      const Mesh& crown = tree.meshes[1].mesh;
      std::map<std::pair<Vec3, Vec3>, int> open;
      double six = 0;
      for (const Triangle& t : crown.triangles) {
        six += dot(crown.positions[t[0]], cross(crown.positions[t[1]], crown.positions[t[2]]));
        for (int i = 0; i < 3; ++i) {
          const Vec3 a = crown.positions[t[i]], b = crown.positions[t[(i + 1) % 3]];
          if (a < b)
            ++open[{a, b}];
          else
            --open[{b, a}];
        }
      }
      EXPECT_GT(six, 0);
      for (const auto& [edge, count] : open) EXPECT_EQ(count, 0);
    }
}

}  // namespace
}  // namespace citykiln::plants
