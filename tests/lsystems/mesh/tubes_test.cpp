#include "lsystems/mesh/tubes.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "lsystems/mesh/leaves.h"
#include "lsystems/rewriting/turtle.h"
#include "tests/lsystems/derived.h"

namespace citykiln::lsystems {
namespace {

Skeleton grown_skeleton(const std::string& text) { return grow(system_of(text)).skeleton; }
Skeleton figure_skeleton(const std::string& name) {
  return grown_skeleton(text_of_tree("lsystems/book/fig_" + name + ".lsys"));
}

PlantMesh meshed(const Skeleton& skeleton, double tolerance_m, double flare = 0) {
  TubeOptions options;
  options.tolerance_m = tolerance_m;
  options.flare = flare;
  return mesh_plant(skeleton, options);
}

std::vector<std::uint32_t> vertex_ids(const PartMesh& mesh) {
  std::map<Vec3, std::uint32_t> places;
  std::vector<std::uint32_t> ids;
  for (const Vec3 p : mesh.positions)
    ids.push_back(places.try_emplace(p, static_cast<std::uint32_t>(places.size())).first->second);
  return ids;
}

// How often each directed edge is used.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edge_uses(const PartMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  const std::vector<std::uint32_t> place = vertex_ids(mesh);
  for (const Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = place[t[i]], b = place[t[(i + 1) % 3]];
      if (a != b) ++uses[{a, b}];
    }
  return uses;
}

bool is_closed(const PartMesh& mesh) {
  const auto uses = edge_uses(mesh);
  for (const auto& [edge, count] : uses) {
    const auto other = uses.find({edge.second, edge.first});
    if (other == uses.end() || other->second != count) return false;
  }
  return true;
}

bool is_manifold(const PartMesh& mesh) {
  for (const auto& [edge, count] : edge_uses(mesh))
    if (count != 1) return false;
  return is_closed(mesh);
}

double volume_of(const PartMesh& mesh) {
  double volume = 0;
  for (const Triangle& t : mesh.triangles)
    volume += dot(mesh.positions[t[0]], cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  return volume;
}

bool is_finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void expect_sound(const PartMesh& mesh) {
  ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
  ASSERT_EQ(mesh.positions.size(), mesh.uvs.size());
  for (const Vec3 p : mesh.positions) ASSERT_TRUE(is_finite(p));
  for (const Vec3 n : mesh.normals) ASSERT_NEAR(length(n), 1, 1e-9);
  for (const Vec2 uv : mesh.uvs) ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t corner : t) ASSERT_LT(corner, mesh.positions.size());
}

// A stem with one to `most` branches at each node, in random directions.
Skeleton random_plant(std::uint32_t seed, int most, int nodes) {
  std::mt19937 random(seed);
  const auto drawn = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  std::string text = "!(0.4)F(2)";
  for (int i = 0; i < nodes; ++i) {
    const int branches = 1 + static_cast<int>(drawn(0, most));
    for (int b = 0; b < branches; ++b)
      text += fmt::format("[/({})&({})!({})F({})&({})F({})]", drawn(0, 360), drawn(15, 130), drawn(0.05, 0.35),
                          drawn(0.2, 2), drawn(-30, 30), drawn(0.2, 1));
    text += fmt::format("/({})&({})!({})F({})", drawn(0, 360), drawn(0, 40), drawn(0.2, 0.4), drawn(0.3, 2));
  }
  return grown_skeleton("axiom: " + text + "\n");
}

// Ericson, "Real-Time Collision Detection", 5.1.5
double distance_to(Vec3 p, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, normal = cross(ab, ac);
  const auto to_edge = [&](Vec3 from, Vec3 along) {
    const double l2 = dot(along, along), t = l2 > 0 ? std::clamp(dot(p - from, along) / l2, 0.0, 1.0) : 0;
    return length(p - from - along * t);
  };
  const double area2 = dot(normal, normal);
  const double v = area2 > 0 ? dot(cross(p - a, ac), normal) / area2 : -1;
  const double w = area2 > 0 ? dot(cross(ab, p - a), normal) / area2 : -1;
  if (v >= 0 && w >= 0 && v + w <= 1) return std::abs(dot(p - a, normal)) / std::sqrt(area2);
  return std::min({to_edge(a, ab), to_edge(a, ac), to_edge(b, c - b)});
}

// The largest distance from corners and centres of every `stride`th triangle to another mesh.
double farthest(const PartMesh& from, const PartMesh& to, std::size_t stride) {
  std::vector<double> extents;
  for (const Triangle& t : to.triangles)
    extents.push_back(
        std::max(length(to.positions[t[1]] - to.positions[t[0]]), length(to.positions[t[2]] - to.positions[t[0]])));
  double most = 0;
  for (std::size_t i = 0; i < from.triangles.size(); i += stride) {
    const Triangle& t = from.triangles[i];
    const Vec3 a = from.positions[t[0]], b = from.positions[t[1]], c = from.positions[t[2]];
    for (const Vec3 p : {a, (a + b + c) * (1 / 3.0), (a + b) * 0.5}) {
      double least = 1e300;
      for (std::size_t j = 0; j < to.triangles.size() && least > most; ++j) {
        const Vec3 d = to.positions[to.triangles[j][0]], e = to.positions[to.triangles[j][1]];
        if (length(p - d) - extents[j] < least)
          least = std::min(least, distance_to(p, d, e, to.positions[to.triangles[j][2]]));
      }
      most = std::max(most, least);
    }
  }
  return most;
}

TEST(Tubes, OfNoSegmentsAreEmpty) {
  const PlantMesh mesh = meshed({}, 0.01);
  EXPECT_TRUE(mesh.bark.positions.empty() && mesh.bark.triangles.empty() && mesh.leaf.triangles.empty());
  EXPECT_EQ(mesh.error_m, 0);
}

TEST(Tubes, AreClosedManifoldsAtJoints) {
  for (const char* name : {"2_6a", "2_6d", "2_7c", "2_8a"}) {
    const PlantMesh mesh = meshed(figure_skeleton(name), name[2] == '8' ? 2 : 0.005, 0.6);
    EXPECT_GT(mesh.joints, 60U) << name;
    EXPECT_EQ(mesh.separate_stems, 1U) << name;
    EXPECT_TRUE(is_manifold(mesh.bark)) << name;
    expect_sound(mesh.bark);
  }
}

TEST(Tubes, AreClosedOnRandomPlants) {
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    const Skeleton plant = random_plant(seed, 1 + static_cast<int>(seed % 6), 6);
    for (const double tolerance_m : {0.2, 0.03, 0.01}) {
      const PlantMesh mesh = meshed(plant, tolerance_m, 0.6);
      EXPECT_TRUE(is_closed(mesh.bark)) << seed;
      expect_sound(mesh.bark);
      EXPECT_GT(volume_of(mesh.bark), 0);
    }
  }
}

TEST(Tubes, LookOutward) {
  const PlantMesh mesh = meshed(figure_skeleton("2_7b"), 0.002);
  std::size_t inward = 0;
  for (const Triangle& t : mesh.bark.triangles) {
    const auto& p = mesh.bark.positions;
    const Vec3 area = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
    inward += dot(area, mesh.bark.normals[t[0]] + mesh.bark.normals[t[1]] + mesh.bark.normals[t[2]]) < 0 ? 1 : 0;
  }
  EXPECT_LT(inward, mesh.bark.triangles.size() / 500);
  EXPECT_GT(volume_of(mesh.bark), 0);
}

TEST(Tubes, HaveTheVolumeOfACylinder) {
  const double exact = 3.14159265358979 * 0.3 * 0.3 * 4;
  const Skeleton stem = grown_skeleton("axiom: !(0.6)F(1)F(1)F(2)\n");
  EXPECT_NEAR(volume_of(meshed(stem, 0.0005).bark), exact, 0.01 * exact);
  EXPECT_LT(volume_of(meshed(stem, 0.05).bark), exact);
}

TEST(Tubes, KeepTheStemThroughAJoint) {
  // a twig hardly changes the volume of the stem it leaves
  const double exact = 3.14159265358979 * 0.3 * 0.3 * 4;
  const Skeleton stem = grown_skeleton("axiom: !(0.6)F(2)[+(60)!(0.1)F(0.5)]F(2)\n");
  const PlantMesh mesh = meshed(stem, 0.0005);
  EXPECT_EQ(mesh.joints, 1U);
  EXPECT_NEAR(volume_of(mesh.bark), exact, 0.03 * exact);
}

TEST(Tubes, StayWithinTheirError) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    // thick enough that nothing is left out
    const Skeleton plant = random_plant(seed, 1 + static_cast<int>(seed % 4), 2);
    const PlantMesh fine = meshed(plant, 0.004);
    for (const double tolerance_m : {0.045, 0.015}) {
      const PlantMesh coarse = meshed(plant, tolerance_m);
      ASSERT_EQ(coarse.left_out, 0U);
      const double allowed = coarse.error_m + fine.error_m;
      EXPECT_LE(farthest(fine.bark, coarse.bark, 1 + fine.bark.triangles.size() / 1000), allowed) << seed;
      EXPECT_LE(farthest(coarse.bark, fine.bark, 1 + coarse.bark.triangles.size() / 300), allowed) << seed;
    }
  }
}

TEST(Joints, StayWithinTheirError) {
  // thin, long stems: all error is the joint's
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    std::mt19937 random(seed);
    const auto drawn = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    std::string text = "!(0.5)F(2)";
    for (std::uint32_t i = 0; i <= seed % 4; ++i)
      text += fmt::format("[/({})&({})!({})F({})]", drawn(0, 360), drawn(18, 120), drawn(0.2, 0.5), drawn(0.5, 3));
    const Skeleton plant = grown_skeleton(fmt::format("axiom: {}/({})&({})F(2)\n", text, drawn(0, 360), drawn(0, 45)));
    const PlantMesh fine = meshed(plant, 0.02);
    for (const double tolerance_m : {0.19, 0.08}) {
      const PlantMesh coarse = meshed(plant, tolerance_m);
      ASSERT_EQ(coarse.left_out, 0U);
      const double allowed = coarse.error_m + fine.error_m;
      EXPECT_LE(farthest(fine.bark, coarse.bark, 1 + fine.bark.triangles.size() / 800), allowed) << seed;
      EXPECT_LE(farthest(coarse.bark, fine.bark, 1 + coarse.bark.triangles.size() / 150), allowed) << seed;
    }
  }
}

TEST(Tubes, HaveAnErrorWithinTheTolerance) {
  for (const char* name : {"2_6a", "2_6c", "2_7b"})
    for (const double tolerance_m : {0.1, 0.02, 0.005, 0.002}) {
      const PlantMesh mesh = meshed(figure_skeleton(name), tolerance_m, 0.6);
      EXPECT_FALSE(mesh.bark.triangles.empty()) << name;
      EXPECT_LE(mesh.error_m, tolerance_m) << name;
    }
}

TEST(Tubes, HaveNoMoreTrianglesAtCoarserTolerances) {
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const Skeleton plant = random_plant(seed, 3, 8);
    std::size_t last = meshed(plant, 0.002, 0.6).bark.triangles.size();
    ASSERT_GT(last, 0u);
    for (const double tolerance_m : {0.004, 0.016, 0.06, 0.2, 0.5}) {
      const std::size_t count = meshed(plant, tolerance_m, 0.6).bark.triangles.size();
      EXPECT_LE(count, last) << seed << " " << tolerance_m;
      last = count;
    }
  }
}

TEST(Tubes, LeaveOutStemsBelowTheTolerance) {
  const Skeleton plant = grown_skeleton("axiom: !(0.5)F(2)[+!(0.05)F(1)F(1)]F(2)\n");
  EXPECT_EQ(meshed(plant, 0.049).left_out, 0U);
  const PlantMesh coarse = meshed(plant, 0.05);
  EXPECT_EQ(coarse.left_out, 2U);
  EXPECT_EQ(coarse.joints, 0U);
  // stems that carry something thick are kept
  EXPECT_EQ(meshed(grown_skeleton("axiom: !(0.01)F(1)!(0.5)F(1)\n"), 0.05).left_out, 0U);
  EXPECT_TRUE(meshed(plant, 1).bark.triangles.empty());
}

TEST(Tubes, CountSeparateStems) {
  EXPECT_EQ(meshed(grown_skeleton("axiom: F f F\n"), 0.01).separate_stems, 2U);
  const PlantMesh many = meshed(grown_skeleton("axiom: F[+F][-F][&F][^F][/(45)&F][/(90)&F]F\n"), 0.01);
  EXPECT_EQ(many.joints, 1U);
  EXPECT_EQ(many.separate_stems, 3U);
  EXPECT_TRUE(is_closed(many.bark));
}

TEST(Tubes, AreFiniteAndClosedWhateverTheSkeleton) {
  for (const char* text : {
           "F(0)",
           "F(0)F(0)[+F(0)][-F(0)]F(0)",
           "F[F][F]F",
           "F[F][F][F][F][F][F]",
           "F|F",
           "F[|F]F",
           "F[|F][|F]|F",
           "!(0)F(1)F(1)",
           "!(0)F(1)[+F]!(1)F",
           "!(1)F(1)[+!(0)F]!(0)F",
           "F(-1)[+F(-2)]F(1)",
           "!(100)F(0.001)[+F(0.001)]F",
           "F(1e8)[+F(1e-8)]F(1e8)",
           "!(1e9)F(1e9)[+F(1e9)]F",
           "f(1)F[+(90)F][-(90)F]",
           "[F][F][F]",
           "!(1)F[&(1)F][&(2)F]F",
       })
    for (const double tolerance_m : {0.0, 0.01, 5.0}) {
      const PlantMesh mesh = meshed(grown_skeleton(std::string("axiom: ") + text + "\n"), tolerance_m, 0.6);
      EXPECT_TRUE(is_closed(mesh.bark)) << text;
      expect_sound(mesh.bark);
      EXPECT_TRUE(std::isfinite(mesh.error_m)) << text;
    }
}

TEST(Tubes, AreTheSameAgain) {
  const Skeleton plant = random_plant(3, 4, 8);
  const PlantMesh once = meshed(plant, 0.01), again = meshed(plant, 0.01);
  EXPECT_EQ(once.bark.positions, again.bark.positions);
  EXPECT_EQ(once.bark.normals, again.bark.normals);
  EXPECT_EQ(once.bark.triangles, again.bark.triangles);
  PlantMesh reused = meshed(random_plant(4, 4, 9), 0.01);
  TubeOptions options;
  options.tolerance_m = 0.01;
  options.flare = 0;
  mesh_plant(plant, options, reused);
  EXPECT_EQ(once.bark.positions, reused.bark.positions);
  EXPECT_EQ(once.bark.triangles, reused.bark.triangles);
  EXPECT_EQ(once.error_m, reused.error_m);
}

TEST(Tubes, WidenAtTheFoot) {
  const Skeleton stem = grown_skeleton("axiom: !(0.4)F(4)\n");
  double widest = 0;
  const PlantMesh mesh = meshed(stem, 0.002, 0.5);
  for (const Vec3 p : mesh.bark.positions)
    if (p.z == 0) widest = std::max(widest, length(in_plan(p)));
  EXPECT_NEAR(widest, 0.3, 1e-9);
  EXPECT_LE(mesh.error_m, 0.002);
  EXPECT_TRUE(is_manifold(mesh.bark));
}

TEST(Tubes, CountMetresAlongTheBark) {
  double most = 0;
  for (const Vec2 uv : meshed(grown_skeleton("axiom: !(0.4)F(1)F(2)[+!(0.05)F(1)]F(3)\n"), 0.002).bark.uvs)
    most = std::max(most, uv.y);
  EXPECT_NEAR(most, 6, 1e-9);
}

// A trunk with a branch to the right, halfway up.
PlantMesh barked(double bark_m) {
  TubeOptions options;
  options.tolerance_m = 0.004, options.flare = 0, options.bark_m = bark_m;
  return mesh_plant(grown_skeleton("axiom: !(0.8)F(4)[/(40)+(60)!(0.4)F(3)!(0.3)F(1)]!(0.5)F(3)!(0.4)F(1)\n"), options);
}

// Whether two texture coordinates show the same texel.
bool look_alike(Vec2 a, Vec2 b, double bark_m) {
  const double off = (a.x - b.x) / bark_m;
  return std::abs(off - std::floor(off + 0.5)) < 1e-6 && std::abs(a.y - b.y) < 1e-6;
}

// Area in the texture over area in space, of triangles that are not end discs.
std::vector<std::pair<double, double>> scales_of(const PartMesh& bark) {
  std::vector<std::pair<double, double>> scales;
  for (const auto& [a, b, c] : bark.triangles) {
    const double area = length(cross(bark.positions[b] - bark.positions[a], bark.positions[c] - bark.positions[a]));
    const double shown = std::abs(cross(bark.uvs[b] - bark.uvs[a], bark.uvs[c] - bark.uvs[a]));
    if (area > 1e-9 && shown > 0) scales.push_back({area, shown / area});
  }
  return scales;
}

TEST(Bark, ContinuesThroughJointsExceptAtSideStems) {
  const double bark_m = 0.5;
  const PartMesh bark = barked(bark_m).bark;
  std::map<Vec3, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < bark.positions.size(); ++i) at[bark.positions[i]].push_back(i);
  // the branch leaves at 4 m, within its own width
  const auto is_at_the_rim = [](Vec3 p) { return std::abs(p.z - 4) < 0.6 && length(in_plan(p)) < 0.7; };
  std::size_t seen = 0, rim = 0;
  for (const auto& [place, vertices] : at)
    for (const std::size_t v : vertices) {
      if (length(bark.normals[v] - bark.normals[vertices[0]]) > 1e-6) continue;  // a stem's end
      ++seen;
      if (look_alike(bark.uvs[v], bark.uvs[vertices[0]], bark_m)) continue;
      ++rim;
      EXPECT_TRUE(is_at_the_rim(place)) << place.x << ' ' << place.y << ' ' << place.z;
    }
  EXPECT_GT(rim, 0u);
  EXPECT_LT(rim, seen / 10);
}

TEST(Bark, HasSimilarTexelSizesEverywhere) {
  double all = 0, even = 0;
  for (const auto& [area, scale] : scales_of(barked(0.25).bark)) {
    all += area;
    if (scale > 0.7 && scale < 1.4) even += area;
  }
  EXPECT_GT(even / all, 0.9);
}

TEST(Bark, HasOnePeriodAroundThinStems) {
  TubeOptions options;
  options.tolerance_m = 0.001, options.bark_m = 1;
  double least = 9, most = 0;
  for (const Vec2 uv : mesh_plant(grown_skeleton("axiom: !(0.05)F(1)F(1)\n"), options).bark.uvs)
    if (uv.y == 1) least = std::min(least, uv.x), most = std::max(most, uv.x);
  EXPECT_EQ(most - least, 1);
}

TEST(Leaves, HaveTheAreaOfTheirPolygons) {
  // an arrow head, which is not convex
  const std::vector<Vec2> ring{{0.5, 0.5}, {0, 2}, {0, 0}, {2, 0}};
  double area = 0;
  for (const Triangle& t : triangulate_ring(ring)) {
    const double twice = cross(ring[t[1]] - ring[t[0]], ring[t[2]] - ring[t[0]]);
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_NEAR(area, 1, 1e-12);
}

TEST(Leaves, OfPolygonsAndInstancesAreMeshed) {
  const PlantMesh mesh = meshed(figure_skeleton("1_25"), 0.1);
  EXPECT_FALSE(mesh.leaf.triangles.empty());
  expect_sound(mesh.leaf);
  const Skeleton with_cards = grown_skeleton("axiom: F(1)~L(2)\n");
  EXPECT_EQ(meshed(with_cards, 0.001).leaf.triangles.size(), 2U);
  EXPECT_EQ(meshed(with_cards, 3).leaf.triangles.size(), 0U);
}

TEST(Leaves, HaveTheSurfaceOfTheirName) {
  const Skeleton plant = grown_skeleton("axiom: F(1)~L(2)\n");
  std::vector<LeafSurface> surfaces(plant.instances[0].kind + 1);
  surfaces.back() = {{{0, 0, 0}, {-1, 1, 0}, {1, 1, 0}}, {{0, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}}};
  TubeOptions options;
  options.surfaces = surfaces;
  const PlantMesh mesh = mesh_plant(plant, options);
  EXPECT_EQ(mesh.leaf.triangles.size(), 1U);
  expect_sound(mesh.leaf);
}

TEST(Leaves, AreFiniteWhateverThePolygon) {
  std::size_t triangles = 0;
  for (const char* text : {"{.F.F.F.}", "{...}", "{.f(1).f(1).}", "{.F+F.+F.F-F.}", "{.f+(120)f.+(120)f.f.}"}) {
    const PlantMesh mesh = meshed(grown_skeleton(std::string("axiom: ") + text + "\n"), 0);
    expect_sound(mesh.leaf);
    triangles += mesh.leaf.triangles.size();
  }
  EXPECT_GT(triangles, 0u);
}

}  // namespace
}  // namespace citykiln::lsystems
