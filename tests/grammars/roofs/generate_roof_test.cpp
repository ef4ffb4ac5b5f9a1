#include "grammars/roofs/generate_roof.h"

#include <gtest/gtest.h>

#include "compiler/contract/random_sequence.h"
#include "tests/grammars/roofs/body.h"
#include "tests/grammars/roofs/footprints.h"
#include "tests/test_files.h"

namespace citykiln::roofs {
namespace {

constexpr double kTolerance_m = 0.02, kWalls_m = 5;

struct Made {
  Roof roof;
  Mesh body;
  Report report;
};

Made make(const Polygon& footprint, RoofShape shape, double tolerance_m = kTolerance_m) {
  Made made;
  made.roof = generate_roof(footprint, shape, tolerance_m, {OsmType::kWay, 1}, made.report);
  made.body = closed_body(made.roof, -kWalls_m);
  return made;
}

RoofShape shape_of(RoofForm form, double height_m = 0) {
  RoofShape shape;
  shape.form = form;
  shape.height_m = height_m;
  return shape;
}

std::vector<RoofForm> all_forms() {
  std::vector<RoofForm> forms;
  for (int i = 0; i < static_cast<int>(RoofForm::kCount); ++i) forms.push_back(static_cast<RoofForm>(i));
  return forms;
}

// The volume of the roof without the walls.
double roof_m3(const Made& made, const Polygon& footprint) {
  return volume_m3(made.body) - area_m2(footprint) * kWalls_m;
}

TEST(GenerateRoof, ClosesWithItsWallsForAllFormsOnAllFootprints) {
  EXPECT_GE(made_footprints().size(), 11u);
  for (const RoofForm form : all_forms())
    for (const NamedFootprint& footprint : made_footprints())
      for (const double overhang_m : {0.0, 0.5}) {
        RoofShape shape = shape_of(form);
        shape.overhang_m = overhang_m;
        const Made made = make(footprint.polygon, shape);
        const std::string what = std::string(name_of(form)) + " on " + footprint.name;
        EXPECT_TRUE(is_closed(made.body)) << what;
        EXPECT_TRUE(is_manifold_at_vertices(made.body)) << what;
        EXPECT_TRUE(has_area_everywhere(made.body)) << what;
        EXPECT_GT(volume_m3(made.body), 0) << what;
        EXPECT_EQ(made.report.diagnoses().size(), 0u) << what;
      }
}

TEST(GenerateRoof, HasTheVolumeOfTheShapeOverARectangle) {
  constexpr double w = 10, l = 16, h = 3, a = w * l;
  const auto mansard = [&] {
    // insets of the rectangle, layer by layer
    double sum = 0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
      const double y = (i + 0.5) / n, x = y < 0.75 ? y * 0.35 / 0.75 : 0.35 + (y - 0.75) * 0.65 / 0.25;
      sum += (l - w * x) * (w - w * x);
    }
    return sum * h / n;
  };
  // a circle's segment: sector less triangle; its centre lies r - h below the eaves
  const double r = (w * w / 4 + h * h) / (2 * h), half_angle = std::asin(w / 2 / r);
  const double segment_m2 = r * r * half_angle - (r - h) * w / 2;
  const double hipped = w * h * (3 * l - w) / 6;
  const std::map<RoofForm, double> volumes = {
      {RoofForm::kFlat, 0},
      {RoofForm::kSkillion, a * h / 2},
      {RoofForm::kGabled, a * h / 2},
      {RoofForm::kHipped, hipped},
      {RoofForm::kHalfHipped, a * h / 2 - 2 * (w / 2 * h / 2 / 2) * (w / 4) / 3},
      {RoofForm::kSideHipped, (a * h / 2 + hipped) / 2},
      {RoofForm::kPyramidal, a * h / 3},
      {RoofForm::kCone, a * h / 3},
      {RoofForm::kGambrel, a * h * (0.4 * 0.65 / 2 + 0.6 * (0.65 + 1) / 2)},
      {RoofForm::kMansard, mansard()},
      {RoofForm::kSaltbox, a * h / 2},
      {RoofForm::kDoubleSaltbox, a * h * 0.7},
      {RoofForm::kRound, segment_m2 * l},
      {RoofForm::kCrossGabled, a * h / 2 + 2 * h * (w / 2) * (w / 2) / 3},
      {RoofForm::kSawtooth, a * h / 2},
      {RoofForm::kGabledRow, a * h / 2},
  };
  const Polygon footprint{box(0, 0, l, w), {}};
  for (const auto& [form, volume] : volumes) {
    const Made made = make(footprint, shape_of(form, h));
    EXPECT_NEAR(roof_m3(made, footprint), volume, 0.01 * volume + 1e-9) << name_of(form);
    EXPECT_EQ(made.roof.height_m, form == RoofForm::kFlat ? 0 : h) << name_of(form);
  }
}

TEST(GenerateRoof, HasTheVolumeOfTheShapeOverOtherFootprints) {
  const auto all = made_footprints();
  const auto named = [&](const std::string& name) {
    return std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; })->polygon;
  };
  constexpr double h = 4;
  const auto volume_of = [&](RoofForm form, const std::string& name, double height_m) {
    return roof_m3(make(named(name), shape_of(form, height_m)), named(name));
  };
  for (const char* name : {"L", "T", "cross", "circle", "sliver"})
    EXPECT_NEAR(volume_of(RoofForm::kPyramidal, name, h), area_m2(named(name)) * h / 3,
                0.01 * area_m2(named(name)) * h / 3);
  // half a ball, and half an ellipsoid
  for (const double height_m : {7.9375, 12.0})
    EXPECT_NEAR(volume_of(RoofForm::kDome, "circle", height_m), area_m2(named("circle")) * height_m * 2 / 3,
                0.01 * area_m2(named("circle")) * height_m * 2 / 3);
  // every section across a wing 8 m wide is a triangle of 4 h; where wings meet, four quarters of a pyramid are more
  const double cross_m3 = 4 * 8 * 8 * h / 2 + (8 * 8 * h / 2 + 2 * h * 4 * 4 / 3);
  EXPECT_NEAR(volume_of(RoofForm::kGabled, "cross", h), cross_m3, 0.01 * cross_m3);
  // a ring of roofs: the triangle's area times the length of its middle line, by Pappus
  const Polygon ring{box(0, 0, 26, 22), {hole(8, 8, 18, 14)}};
  const double ring_m3 = 8 * h / 2 * (2 * 18 + 2 * 14);
  for (const RoofForm form : {RoofForm::kHipped, RoofForm::kGabled})
    EXPECT_NEAR(roof_m3(make(ring, shape_of(form, h)), ring), ring_m3, 0.01 * ring_m3);
}

TEST(GenerateRoof, RunsRidgesAlongTheLongerSide) {
  // turned against the axes
  const Vec2 along = {0.8, 0.6};
  Polygon footprint;
  for (const Vec2 p : box(0, 0, 20, 8)) footprint.outer.push_back(along * p.x + left_of(along) * p.y);
  const auto ridge_of = [&](const RoofShape& shape) {
    const Made made = make(footprint, shape);
    Box2 box;
    for (const Vec3 p : made.roof.positions)
      if (p.z > made.roof.height_m - 0.01) box.grow({dot(along, in_plan(p)), dot(left_of(along), in_plan(p))});
    return Vec2{box.width(), box.height()};
  };
  RoofShape shape = shape_of(RoofForm::kGabled, 3);
  EXPECT_NEAR(ridge_of(shape).x, 20, 0.01);
  EXPECT_NEAR(ridge_of(shape).y, 0, 0.01);
  EXPECT_NEAR(ridge_of(shape_of(RoofForm::kHipped, 3)).x, 12, 0.01);
  shape.is_ridge_across = true;
  EXPECT_NEAR(ridge_of(shape).x, 0, 0.01);
  EXPECT_NEAR(ridge_of(shape).y, 8, 0.01);
  // a compass word, 20 degrees off
  shape = shape_of(RoofForm::kGabled, 3);
  shape.direction = Vec2{0.94, 0.34};
  EXPECT_NEAR(ridge_of(shape).y, 8, 0.01);
}

TEST(GenerateRoof, FallsWhereItsDirectionPoints) {
  RoofShape shape = shape_of(RoofForm::kSkillion, 3);
  for (const Vec2 downhill : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
    shape.direction = downhill;
    const Made made = make({box(0, 0, 16, 10), {}}, shape);
    EXPECT_EQ(std::ranges::count(made.roof.parts, RoofPart::kRoof), 2);
    for (std::size_t i = 0; i < made.roof.triangles.size(); ++i) {
      if (made.roof.parts[i] != RoofPart::kRoof) continue;
      const Triangle t = made.roof.triangles[i];
      const Vec3 a = made.roof.positions[t[0]];
      const Vec3 normal = cross(made.roof.positions[t[1]] - a, made.roof.positions[t[2]] - a);
      EXPECT_GT(dot(in_plan(normal), downhill), 0);
    }
  }
}

double gables_m2(const Roof& roof) {
  double sum = 0;
  for (std::size_t i = 0; i < roof.triangles.size(); ++i) {
    const Triangle t = roof.triangles[i];
    const Vec3 a = roof.positions[t[0]];
    if (roof.parts[i] == RoofPart::kGable) sum += length(cross(roof.positions[t[1]] - a, roof.positions[t[2]] - a)) / 2;
  }
  return sum;
}

TEST(GenerateRoof, PutsGablesWhereWingsEnd) {
  const Polygon t = made_footprints()[2].polygon;
  EXPECT_NEAR(gables_m2(make(t, shape_of(RoofForm::kGabled, 3)).roof), 3 * 8 * 3 / 2.0, 0.05);
}

// Every face of a square's skeleton is a triangle; only two of them are ends.
TEST(RoofBySkeleton, PutsTwoGablesOnASquare) {
  const auto roof =
      roof_by_skeleton({box(0, 0, 10, 10), {}}, shape_of(RoofForm::kGabled, 3), 0.02, SkeletonKernel::kInexact);
  ASSERT_TRUE(roof);
  EXPECT_NEAR(gables_m2(*roof), 2 * 10 * 3 / 2.0, 0.05);
}

TEST(GenerateRoof, TakesItsHeightFromHeightThenAngleThenLevels) {
  const Polygon footprint{box(0, 0, 16, 10), {}};
  RoofShape shape = shape_of(RoofForm::kGabled);
  shape.levels = 2;
  EXPECT_EQ(make(footprint, shape).roof.height_m, 6);
  shape.angle_deg = 45;
  EXPECT_NEAR(make(footprint, shape).roof.height_m, 5, 0.001);
  shape.height_m = 2.5;
  EXPECT_EQ(make(footprint, shape).roof.height_m, 2.5);
}

TEST(GenerateRoof, KeepsTheFootprintsCorners) {
  for (const RoofForm form : all_forms())
    for (const NamedFootprint& footprint : made_footprints()) {
      const Made made = make(footprint.polygon, shape_of(form));
      std::set<Vec2> eaves;
      for (const auto& ring : made.roof.eaves)
        for (const std::uint32_t v : ring) {
          EXPECT_EQ(made.roof.positions[v].z, 0);
          eaves.insert(in_plan(made.roof.positions[v]));
        }
      // the tip of a needle that is narrower than the grid closes
      if (footprint.name == "near-degenerate") continue;
      for (const Vec2 p : footprint.polygon.outer) EXPECT_EQ(eaves.count(p), 1u) << name_of(form) << footprint.name;
    }
}

TEST(GenerateRoof, LetsEavesStandOutAndDown) {
  const Polygon footprint{box(0, 0, 16, 10), {}};
  for (const RoofForm form : {RoofForm::kGabled, RoofForm::kHipped, RoofForm::kPyramidal, RoofForm::kFlat}) {
    RoofShape shape = shape_of(form, 5);
    shape.overhang_m = 0.5;
    const Made made = make(footprint, shape);
    Box2 box;
    double lowest_m = 0;
    for (const Vec3 p : made.roof.positions) box.grow(in_plan(p)), lowest_m = std::min(lowest_m, p.z);
    EXPECT_EQ(box, (Box2{{-0.5, -0.5}, {16.5, 10.5}}));
    EXPECT_NEAR(lowest_m, form == RoofForm::kFlat ? 0 : -0.5, 0.005) << name_of(form);
  }
}

TEST(GenerateRoof, StatesTheErrorOfCurves) {
  const Polygon round{circle({0, 0}, 8, 64), {}};
  for (const RoofForm form : {RoofForm::kDome, RoofForm::kRound, RoofForm::kOnion}) {
    std::size_t triangles = 0;
    for (const double tolerance_m : {0.5, 0.1, 0.02}) {
      const Made made = make(round, shape_of(form, 8), tolerance_m);
      EXPECT_LE(made.roof.error_m, tolerance_m) << name_of(form);
      EXPECT_GT(made.roof.triangles.size(), triangles) << name_of(form);
      triangles = made.roof.triangles.size();
    }
  }
  // the sphere is within the stated error of the dome
  const Made dome = make(round, shape_of(RoofForm::kDome, 8), 0.1);
  for (const Triangle& t : dome.roof.triangles) {
    const Vec3 middle = (dome.roof.positions[t[0]] + dome.roof.positions[t[1]] + dome.roof.positions[t[2]]) * (1 / 3.0);
    const double in_plan_m = 8 * (1 - std::cos(3.14159265 / 64));
    EXPECT_NEAR(length(middle), 8, dome.roof.error_m + in_plan_m + 0.01);
  }
}

TEST(GenerateRoof, StaysWithinTheErrorItStates) {
  for (const RoofForm form : all_forms())
    for (const NamedFootprint& footprint : made_footprints()) {
      const Made fine = make(footprint.polygon, shape_of(form), 0.02);
      EXPECT_FALSE(fine.roof.triangles.empty());
      for (const double tolerance_m : {0.1, 0.5, 2.5}) {
        const Made coarse = make(footprint.polygon, shape_of(form), tolerance_m);
        const double stated_m = fine.roof.error_m + coarse.roof.error_m + 4 * kQuantum_m;
        const std::string what = std::string(name_of(form)) + " on " + footprint.name;
        EXPECT_LE(coarse.roof.error_m, tolerance_m) << what;
        EXPECT_LE(distance_m(fine.body, coarse.body), stated_m) << what;
        EXPECT_LE(distance_m(coarse.body, fine.body), stated_m) << what;
      }
    }
}

// Eaves overhang, and lift the roof by their thickness.
TEST(GenerateRoof, StatesWhatLeavingOutEavesMoves) {
  for (const RoofForm form : {RoofForm::kFlat, RoofForm::kSkillion, RoofForm::kGabled, RoofForm::kHipped,
                              RoofForm::kPyramidal, RoofForm::kMansard})
    for (const NamedFootprint& footprint : made_footprints())
      for (const double rise_m : {0.3, 2.0}) {
        // a skeleton may change its shape with its eaves, and the roof of a sliver is nearly vertical
        if (footprint.name == "sliver" || footprint.name == "near-degenerate") continue;
        RoofShape shape = shape_of(form, form == RoofForm::kFlat ? 0 : rise_m);
        shape.overhang_m = 0.4;
        const Made fine = make(footprint.polygon, shape, 0.01);
        EXPECT_FALSE(fine.roof.triangles.empty());
        for (const double tolerance_m : {0.25, 1.25, 6.0}) {
          const Made coarse = make(footprint.polygon, shape, tolerance_m);
          const double stated_m = fine.roof.error_m + coarse.roof.error_m + 4 * kQuantum_m;
          const std::string what = std::string(name_of(form)) + " on " + footprint.name;
          EXPECT_LE(coarse.roof.error_m, tolerance_m) << what;
          EXPECT_LE(distance_m(fine.body, coarse.body), stated_m) << what << " at " << tolerance_m;
          EXPECT_LE(distance_m(coarse.body, fine.body), stated_m) << what << " at " << tolerance_m;
        }
      }
}

TEST(GenerateRoof, IsFlatBelowTheTolerance) {
  const Made made = make({box(0, 0, 16, 10), {}}, shape_of(RoofForm::kGabled, 2), 2.5);
  EXPECT_EQ(made.roof.form, RoofForm::kFlat);
  EXPECT_EQ(made.roof.error_m, 2);
  EXPECT_EQ(made.report.diagnoses().size(), 0u);
}

TEST(GenerateRoof, NumbersFlatFacesOnce) {
  for (const RoofForm form : all_forms()) {
    const Made made = make({box(0, 0, 16, 10), {}}, shape_of(form, 3));
    EXPECT_FALSE(made.roof.triangles.empty());
    std::map<std::pair<RoofPart, std::uint32_t>, Vec3> normals;
    for (std::size_t i = 0; i < made.roof.triangles.size(); ++i) {
      const Triangle t = made.roof.triangles[i];
      const Vec3 a = made.roof.positions[t[0]];
      const Vec3 area = cross(made.roof.positions[t[1]] - a, made.roof.positions[t[2]] - a);
      if (length(area) < 0.5) continue;
      const auto [first, is_new] = normals.try_emplace({made.roof.parts[i], made.roof.faces[i]}, unit(area));
      EXPECT_GT(dot(first->second, unit(area)), 0.9995) << name_of(form) << ' ' << i;
    }
  }
}

TEST(GenerateRoof, DiagnosesAFootprintWithoutArea) {
  for (const Polygon& none : {Polygon{}, Polygon{{{0, 0}, {5, 0}}, {}}, Polygon{{{0, 0}, {5, 0}, {9, 0}}, {}}}) {
    const Made made = make(none, shape_of(RoofForm::kHipped));
    EXPECT_TRUE(made.roof.triangles.empty());
    ASSERT_EQ(made.report.diagnoses().size(), 1u);
    EXPECT_EQ(made.report.diagnoses()[0].code, Code::kRoofFallback);
  }
}

TEST(GenerateRoof, KnowsItsNames) {
  for (const RoofForm form : all_forms()) EXPECT_EQ(form_named(name_of(form)), form);
  EXPECT_EQ(form_named("crosspitched"), RoofForm::kCrossGabled);
  EXPECT_EQ(form_named("many"), std::nullopt);
}

TEST(GenerateRoof, SynonymsAreReadInAnyCapitals) {
  const std::pair<const char*, RoofForm> rows[] = {
      {"Gabled", RoofForm::kGabled},          {"HIPPED", RoofForm::kHipped},
      {"half_hipped", RoofForm::kHalfHipped}, {"Half-Hipped", RoofForm::kHalfHipped},
      {"shed", RoofForm::kSkillion},          {"Lean-to roof", RoofForm::kSkillion},
      {"monopitch", RoofForm::kSkillion},     {"barrel", RoofForm::kRound},
      {"spherical", RoofForm::kDome},         {"conical", RoofForm::kCone},
      {"saw tooth", RoofForm::kSawtooth},     {"hipped-and-gabled", RoofForm::kHipped}};
  for (const auto& [name, form] : rows) EXPECT_EQ(form_named(name), form) << name;
  for (const char* unknown : {"", "_roof", "gabledd", "9.0"}) EXPECT_EQ(form_named(unknown), std::nullopt) << unknown;
}

// ---- random footprints

class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : draw_(seed, StableId{seed}, "roof test") {}
  double between(double low, double high) { return low + (high - low) * draw_.unit(next_++); }
  int below(int n) { return std::min(n - 1, static_cast<int>(between(0, n))); }

 private:
  RandomSequence draw_;
  std::uint32_t next_ = 0;
};

// A star with random radii, which is simple, or random points, which mostly are not.
Ring star_or_random_corners(RandomSource& random, Vec2 centre, double radius_m, bool is_simple) {
  Ring ring;
  const int corners = 3 + random.below(14);
  for (int i = 0; i < corners; ++i) {
    const double turn = is_simple ? (i + random.between(0, 0.9)) / corners : random.between(0, 1);
    ring.push_back(snapped_to(0x1p-7, centre + direction_of(turn) * (radius_m * random.between(0.2, 1))));
  }
  return ring;
}

// A rectilinear outline with notches.
Ring random_steps(RandomSource& random) {
  Ring ring;
  double x = 0;
  const int steps = 2 + random.below(5);
  for (int i = 0; i < steps; ++i) {
    const double top = 2 + random.below(8) * 1.5;
    ring.push_back({x, top});
    x += 1 + random.below(5);
    ring.push_back({x, top});
  }
  ring.push_back({x, 0});
  ring.push_back({0, 0});
  std::reverse(ring.begin(), ring.end());
  return ring;
}

Polygon random_footprint(RandomSource& random) {
  const int kind = random.below(8);
  if (kind < 2) return {random_steps(random), {}};
  Polygon polygon{star_or_random_corners(random, {0, 0}, random.between(1, 30), kind < 7), {}};
  for (int i = random.below(3); i > 0; --i)
    polygon.holes.push_back(star_or_random_corners(random, {random.between(-4, 4), random.between(-4, 4)},
                                                   random.between(0.1, 6), kind < 6));
  return polygon;
}

TEST(GenerateRoof, ClosesOverRandomFootprints) {
  const auto count = static_cast<std::uint64_t>(quick_or_full(2000, 10000));
  std::size_t fallbacks = 0, triangles = 0;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    RandomSource random(seed);
    const Polygon footprint = random_footprint(random);
    RoofShape shape = shape_of(static_cast<RoofForm>(random.below(static_cast<int>(RoofForm::kCount))));
    if (random.below(2)) shape.direction = direction_of(random.between(0, 1));
    if (random.below(3) == 0) shape.overhang_m = random.between(0, 1.5);
    if (random.below(3) == 0) shape.height_m = random.between(0, 20);
    shape.is_ridge_across = random.below(2) == 1;
    const Made made = make(footprint, shape, random.below(2) ? 0.02 : 0.5);
    ASSERT_TRUE(is_closed(made.body)) << seed;
    ASSERT_TRUE(is_manifold_at_vertices(made.body)) << seed;
    fallbacks += made.report.diagnoses().size();
    triangles += made.roof.triangles.size();
    for (const Vec3 p : made.roof.positions) ASSERT_EQ(snapped(p), p) << seed;
    for (const Vec3 p : made.roof.positions) ASSERT_LT(p.z, 200) << seed;
  }
  EXPECT_GT(triangles, 10 * count);
  std::printf("fallbacks: %zu of %zu random footprints\n", fallbacks, static_cast<std::size_t>(count));
}

}  // namespace
}  // namespace citykiln::roofs
