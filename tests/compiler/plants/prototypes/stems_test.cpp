#include "compiler/plants/prototypes/stems.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lsystems/reading/read_lsystem.h"
#include "lsystems/rewriting/turtle.h"

namespace citykiln::plants {
namespace {

lsystems::Skeleton grown(const char* text) {
  return lsystems::grow(*lsystems::read_lsystem(text, "stem.lsys")).skeleton;
}

// A trunk of radius 0.5 with a branch of 0.1 and a twig of 0.02 on it.
lsystems::Skeleton branched() { return grown("axiom: !(1)F(4)[+(60)!(0.2)F(3)[+(30)!(0.04)F(2)]]F(4)\n"); }

double extent_m(const StemMesh& stems) {
  double farthest = 0;
  for (const Vec3 p : stems.mesh.positions) farthest = std::max(farthest, length(in_plan(p)));
  return farthest;
}

TEST(Stems, AreLeftOutBelowTheTolerance) {
  EXPECT_GT(extent_m(mesh_stems(branched(), 0.01)), 4);
  EXPECT_LT(extent_m(mesh_stems(branched(), 0.03)), 3);
  EXPECT_LT(extent_m(mesh_stems(branched(), 0.15)), 1);
  // the trunk stays
  EXPECT_FALSE(mesh_stems(branched(), 5).mesh.triangles.empty());
}

TEST(Stems, ArePrismsWhereTheyAreThin) {
  const auto triangles = [](double tolerance_m) { return mesh_stems(branched(), tolerance_m).mesh.triangles.size(); };
  EXPECT_LT(triangles(0.05), triangles(0.01));
  // both segments of the trunk are one prism
  EXPECT_EQ(triangles(0.25), 6u);
}

// Samples of the prism's sides against the round stem.
TEST(Stems, ThatArePrismsHaveTheirErrorFromRound) {
  const StemMesh stems = mesh_stems(grown("axiom: !(0.2)F(3)\n"), 0.05);
  ASSERT_EQ(stems.mesh.triangles.size(), 6u);
  double out = 0, within = 0;
  for (const Triangle& t : stems.mesh.triangles)
    for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vec3 p = stems.mesh.positions[t[0]] * (1 - u) + stems.mesh.positions[t[1]] * u;
      out = std::max(out, length(in_plan(p)) - 0.1), within = std::max(within, 0.1 - length(in_plan(p)));
    }
  EXPECT_LE(std::max(out, within), stems.error_m + 1e-9);
  EXPECT_GE(within, 0.9 * stems.error_m);
  EXPECT_LE(stems.error_m, 0.05);
}

TEST(Stems, FaceOutwards) {
  const StemMesh stems = mesh_stems(grown("axiom: !(0.2)F(3)\n"), 0.05);
  ASSERT_FALSE(stems.mesh.triangles.empty());
  for (const Triangle& t : stems.mesh.triangles) {
    const Vec3 a = stems.mesh.positions[t[0]];
    const Vec3 out = cross(stems.mesh.positions[t[1]] - a, stems.mesh.positions[t[2]] - a);
    EXPECT_GT(dot(out, stems.mesh.normals[t[0]]), 0);
  }
}

TEST(Stems, OfNoSegmentsAreEmpty) { EXPECT_TRUE(mesh_stems({}, 0.1).mesh.triangles.empty()); }

}  // namespace
}  // namespace citykiln::plants
