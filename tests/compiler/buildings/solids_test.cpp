// Validates the mass models of buildings by the rules of val3dity: closed by a floor, without party walls.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "compiler/buildings/meshes/mass_model.h"
#include "tests/compiler/buildings/real_buildings.h"
#include "tests/compiler/buildings/val3dity_rules.h"
#include "tests/grammars/roofs/footprints.h"
#include "tests/test_files.h"

namespace citykiln::buildings {
namespace {

using grammars::Face;
using val3dity::Codes;

// Without party walls and buried storeys, with a floor.
Building detached(Building building) {
  building.party_walls.clear();
  building.facade_edges.clear();
  building.stands_on_ground = false;
  return building;
}

std::vector<Face> solid_of(const Building& building, double tolerance_m, Report& report) {
  const MassModel mass = mass_model_of(building, tolerance_m, report);
  std::vector<Face> faces = shape_of(building, mass).faces;
  faces.insert(faces.end(), mass.foundation.begin(), mass.foundation.end());
  return faces;
}

// ---- the rules themselves, on cubes with one fault each

std::vector<Face> cube(double low = 0, double high = 10) {
  const auto face = [](std::initializer_list<Vec3> ring) {
    Face f;
    f.outer = ring;
    return f;
  };
  const double a = low, b = high;
  return {face({{a, a, a}, {a, b, a}, {b, b, a}, {b, a, a}}), face({{a, a, b}, {b, a, b}, {b, b, b}, {a, b, b}}),
          face({{a, a, a}, {b, a, a}, {b, a, b}, {a, a, b}}), face({{b, a, a}, {b, b, a}, {b, b, b}, {b, a, b}}),
          face({{b, b, a}, {a, b, a}, {a, b, b}, {b, b, b}}), face({{a, b, a}, {a, a, a}, {a, a, b}, {a, b, b}})};
}

grammars::Ring3 hole(double x0, double x1, double y0 = 2, double y1 = 8) {
  return {{x0, y0, 10}, {x0, y1, 10}, {x1, y1, 10}, {x1, y0, 10}};
}

Codes of_cube_with_top(const grammars::Ring3& outer, std::vector<grammars::Ring3> holes = {}) {
  std::vector<Face> faces = cube();
  faces[1].outer = outer;
  faces[1].holes = std::move(holes);
  return val3dity::codes_of(faces);
}

const grammars::Ring3 kTop = {{0, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10}};

TEST(Val3dityRules, FindNothingWrongWithACube) { EXPECT_EQ(val3dity::codes_of(cube()), Codes{}); }

TEST(Val3dityRules, FindFaultsOfRings) {
  EXPECT_EQ(of_cube_with_top({{0, 0, 10}, {10, 0, 10}}), Codes{101});
  EXPECT_TRUE(of_cube_with_top({{0, 0, 10}, {10, 0, 10}, {10, 0, 10}, {10, 10, 10}, {0, 10, 10}}).contains(102));
  EXPECT_TRUE(of_cube_with_top({{0, 0, 10}, {10, 0, 10}, {0, 9, 10}, {10, 10, 10}}).contains(104));
}

TEST(Val3dityRules, FindFaultsOfFaces) {
  EXPECT_TRUE(of_cube_with_top(kTop, {hole(2, 12)}).contains(201));
  EXPECT_TRUE(of_cube_with_top(kTop, {hole(2, 6), hole(2, 6)}).contains(202));
  EXPECT_TRUE(of_cube_with_top({{0, 0, 10}, {10, 0, 10}, {10, 10, 10.1}, {0, 10, 10}}).contains(203));
  EXPECT_TRUE(of_cube_with_top({{0, 0, 10}, {10, 0, 10}, {10, 10, 16}, {0, 10, 10}}).contains(204));
  // from wall to wall, with a common point on both
  EXPECT_TRUE(of_cube_with_top(kTop, {{{0, 5, 10}, {5, 8, 10}, {10, 5, 10}, {5, 2, 10}}}).contains(205));
  EXPECT_TRUE(of_cube_with_top(kTop, {hole(12, 14)}).contains(206));
  EXPECT_TRUE(of_cube_with_top(kTop, {hole(2, 8), hole(3, 5, 3, 5)}).contains(207));
  grammars::Ring3 turned = hole(2, 8);
  std::reverse(turned.begin(), turned.end());
  EXPECT_TRUE(of_cube_with_top(kTop, {turned}).contains(208));
}

TEST(Val3dityRules, FindFaultsOfShells) {
  const std::vector<Face> whole = cube();
  EXPECT_TRUE(val3dity::codes_of(std::span(whole).first(3)).contains(301));
  EXPECT_EQ(val3dity::codes_of(std::span(whole).first(5)), Codes{302});
  std::vector<Face> twice = whole, apart = whole, crossing = whole, turned = whole, inside_out;
  twice.push_back(reversed(whole[2]));
  EXPECT_TRUE(val3dity::codes_of(twice).contains(303));
  for (const Face& face : cube(20, 30)) apart.push_back(face);
  EXPECT_EQ(val3dity::codes_of(apart), Codes{305});
  for (const Face& face : cube(5, 15)) crossing.push_back(face);
  EXPECT_EQ(val3dity::codes_of(crossing), (Codes{305, 306}));
  turned[1] = reversed(whole[1]);
  EXPECT_TRUE(val3dity::codes_of(turned).contains(307));
  for (const Face& face : whole) inside_out.push_back(reversed(face));
  EXPECT_EQ(val3dity::codes_of(inside_out), Codes{307});
}

// Two cubes with a common vertex, and with a common edge.
TEST(Val3dityRules, FindBodiesThatTouchThemselves) {
  std::vector<Face> corner = cube(), edge = cube();
  for (const Face& face : cube(10, 20)) corner.push_back(face);
  EXPECT_TRUE(val3dity::codes_of(corner).contains(303));
  for (Face face : cube()) {
    each_vertex(face, [](Vec3& p) { p = p + Vec3{10, 10, 0}; });
    edge.push_back(face);
  }
  EXPECT_TRUE(val3dity::codes_of(edge).contains(303));
}

// ---- footprints of tests

// Rings that touch themselves or each other would have edges with four walls.
bool touches_itself(const Polygon& footprint) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  const auto add = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) edges.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  };
  add(footprint.outer);
  for (const Ring& ring : footprint.holes) add(ring);
  // exact, since coordinates have few bits
  const auto lies_on = [](Vec2 p, Vec2 a, Vec2 b) {
    return cross(b - a, p - a) == 0 && dot(p - a, p - b) <= 0 && p != a && p != b;
  };
  std::map<Vec2, int> starts;
  for (const auto& [a, b] : edges)
    if (++starts[a] > 1) return true;
  for (const auto& [a, b] : edges)
    for (const auto& [p, q] : edges)
      if (lies_on(p, a, b)) return true;
  return false;
}

constexpr double kFinest_m = 0.01, kCoarser_m = 0.25;

TEST(Solid, KeepsVal3ditysRulesOnMadeFootprints) {
  for (int form = 0; form < static_cast<int>(roofs::RoofForm::kCount); ++form)
    for (const roofs::NamedFootprint& footprint : roofs::made_footprints())
      for (const double overhang_m : {0.0, 0.5})
        for (const double tolerance_m : {kFinest_m, kCoarser_m}) {
          if (touches_itself(footprint.polygon)) continue;
          // a dome of 25 cm width ends in a triangle without area
          if (footprint.name == "sliver" && static_cast<roofs::RoofForm>(form) == roofs::RoofForm::kDome) continue;
          Building building;
          building.footprint = footprint.polygon;
          building.stands_on_ground = false;
          building.roof_shape.form = static_cast<roofs::RoofForm>(form);
          building.roof_shape.height_m = form == 0 ? 0 : 3;
          building.roof_shape.overhang_m = overhang_m;
          building.bottom_m = -3, building.top_m = 6 + building.roof_shape.height_m;
          Report report;
          EXPECT_EQ(val3dity::codes_of(solid_of(building, tolerance_m, report)), Codes{})
              << name_of(building.roof_shape.form) << " on " << footprint.name << ", " << tolerance_m;
        }
}

// ---- real footprints that once made invalid solids

struct HardBuilding {
  const char* osm;
  double rise_m, overhang_m;
  Polygon footprint;
};

// w138590242: slivers between roof planes. r1946699: a hole's vertex within a grid step of a wall. w141220771: snapping
// moves a spike across the wall beside it.
const HardBuilding kHardBuildings[] = {
    {"w138590242",
     2.3798828125,
     0.375,
     {{{3525.5, 2618.0703125},
       {3530.171875, 2614.734375},
       {3534.5234375, 2611.625},
       {3533.078125, 2609.515625},
       {3535.734375, 2607.40625},
       {3537.265625, 2609.40625},
       {3539.921875, 2607.515625},
       {3542.6640625, 2606.40625},
       {3543.703125, 2607.7421875},
       {3544.4296875, 2609.078125},
       {3544.265625, 2610.5234375},
       {3543.703125, 2612.6328125},
       {3540.078125, 2615.296875},
       {3536.453125, 2617.9609375},
       {3531.78125, 2621.515625},
       {3529.4453125, 2622.9609375}},
      {}}},
    {"r1946699",
     1.376953125,
     0.375,
     {{{-4520.265625, 3257.8671875},
       {-4517.3671875, 3253.421875},
       {-4516.3203125, 3253.9765625},
       {-4513.75, 3250.0859375},
       {-4513.0234375, 3250.53125},
       {-4510.9375, 3246.859375},
       {-4509.6484375, 3247.75},
       {-4510.6875, 3252.1953125},
       {-4506.09375, 3255.1953125},
       {-4510.84375, 3262.0859375},
       {-4511.3203125, 3264.859375},
       {-4515.2734375, 3261.8671875}},
      {{{-4518.65625, 3258.09375},
        {-4512.1328125, 3262.53125},
        {-4509.640625, 3258.53125},
        {-4516.078125, 3254.203125}}}}},
    {"w141220771",
     2.41796875,
     0.375,
     {{{747.890625, 3631.40625},
       {753.015625, 3631.1640625},
       {753.96875, 3651.375},
       {762.03125, 3651},
       {762.4609375, 3660.1015625},
       {748.328125, 3660.765625},
       {747.90625, 3651.796875},
       {749.125, 3651.7421875},
       {748.8515625, 3651.7578125}},
      {}}},
};

TEST(Solid, KeepsVal3ditysRulesOnHardFootprints) {
  for (const HardBuilding& hard : kHardBuildings)
    for (const double tolerance_m : {kFinest_m, kCoarser_m}) {
      Building building;
      building.footprint = hard.footprint;
      building.stands_on_ground = false;
      building.roof_shape.form = roofs::RoofForm::kGabled;
      building.roof_shape.height_m = hard.rise_m, building.roof_shape.overhang_m = hard.overhang_m;
      building.bottom_m = -3, building.top_m = 7.5 + hard.rise_m;
      Report report;
      EXPECT_EQ(val3dity::codes_of(solid_of(building, tolerance_m, report)), Codes{}) << hard.osm;
      EXPECT_EQ(report.counts()[Code::kRoofFallback], 0u) << hard.osm;
    }
}

// ---- real ones

struct Tally {
  std::size_t solids = 0, touching = 0, valid = 0, fallbacks = 0;
  std::map<int, std::size_t> by_code;
};

void add_solids_of(const Building& planned, double tolerance_m, Tally& tally) {
  Report report;
  const Building building = detached(planned);
  const std::vector<Face> faces = solid_of(building, tolerance_m, report);
  tally.fallbacks += report.counts()[Code::kRoofFallback];
  // diagnosed: footprints without area have no solid
  if (faces.empty() && report.counts()[Code::kRoofFallback] > 0) return;
  if (touches_itself(building.footprint)) {
    ++tally.touching;
    return;
  }
  ++tally.solids;
  const Codes codes = val3dity::codes_of(faces);
  tally.valid += codes.empty();
  for (const int code : codes) ++tally.by_code[code];
  if (codes.empty()) return;
  std::printf("  %s (%s):", to_string(building.id.osm).c_str(), std::string(name_of(building.roof_shape.form)).c_str());
  for (const int code : codes) std::printf(" %d", code);
  std::printf("\n");
}

// One in some buildings of large extracts, or all if CITYKILN_BUILDINGS is "all".
std::size_t every_nth(std::size_t sampled) {
  const char* asked = std::getenv("CITYKILN_BUILDINGS");
  return asked != nullptr && std::string(asked) == "all" ? 1 : sampled;
}

void expect_valid(const std::string& file, std::size_t sampled) {
  if (!std::filesystem::exists(real_data(file))) GTEST_SKIP() << "absent: " << file;
  const std::size_t every = every_nth(sampled);
  const std::vector<Building> buildings = buildings_in(file);
  for (const double tolerance_m : {kFinest_m, kCoarser_m}) {
    Tally tally;
    for (std::size_t i = 0; i < buildings.size(); i += every) add_solids_of(buildings[i], tolerance_m, tally);
    std::printf("%s at %g m: %zu solids, %zu valid; %zu on footprints that touch themselves; %zu flat instead;",
                file.c_str(), tolerance_m, tally.solids, tally.valid, tally.touching, tally.fallbacks);
    for (const auto& [code, count] : tally.by_code) std::printf(" %d: %zu", code, count);
    std::printf("\n");
    EXPECT_EQ(tally.valid, tally.solids);
    EXPECT_LE(static_cast<double>(tally.fallbacks), 0.005 * static_cast<double>(buildings.size() / every) + 1);
  }
}

TEST(SolidsReal, AreValidInHelsinki) { expect_valid("helsinki/Helsinki.osm.pbf", 1); }
TEST(SolidsReal, AreValidInMonaco) { expect_valid("monaco/monaco-2023.osm.pbf", 1); }
TEST(SolidsReal, AreValidInChicago) { expect_valid("chicago-loop/chicago_loop.osm.pbf", 1); }
TEST(SolidsReal, AreValidInNewYork) { expect_valid("nyc/nyc-west-village.osm.pbf", 1); }
TEST(SolidsReal, AreValidInMonacosCadastre) { expect_valid("monaco/monaco-2016-cadastre.osm.pbf", 16); }
TEST(SolidsReal, AreValidInReinickendorf) { expect_valid("berlin/berlin-reinickendorf-2026.osm.pbf", 4); }
TEST(SolidsReal, AreValidInMitte) { expect_valid("berlin/berlin-mitte-gesundbrunnen.osm", 1); }
TEST(SolidsReal, AreValidAroundTheSiegessaeule) { expect_valid("berlin/berlin-siegessaeule.osm.gz", 1); }
TEST(SolidsReal, AreValidInNeukoelln) { expect_valid("berlin/berlin-neukolln.osm", 1); }
TEST(SolidsReal, AreValidInNeubrandenburg) { expect_valid("neubrandenburg/neubrandenburg.osm.bz2", 8); }
TEST(SolidsReal, AreValidInLiechtenstein) { expect_valid("liechtenstein/liechtenstein-2015.osm.pbf", 4); }

}  // namespace
}  // namespace citykiln::buildings
