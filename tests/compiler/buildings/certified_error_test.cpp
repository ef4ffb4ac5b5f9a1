// Compares the stated error of levels with the measured one: distances of sample points on each level to the finest,
// and in the opposite direction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "compiler/buildings/generate.h"
#include "compiler/buildings/styles/style.h"
#include "compiler/geometry/snap.h"
#include "tests/compiler/buildings/nearest_triangle.h"
#include "tests/compiler/buildings/real_buildings.h"
#include "tests/test_files.h"

namespace citykiln::buildings {
namespace {

constexpr double kLadder_m[] = {0.02, 0.1, 0.5, 2.5, 12.5};
constexpr const char* kExtracts[] = {"helsinki/Helsinki.osm.pbf",
                                     "monaco/monaco-2023.osm.pbf",
                                     "chicago-loop/chicago_loop.osm.pbf",
                                     "nyc/nyc-west-village.osm.pbf",
                                     "neubrandenburg/neubrandenburg.osm.bz2",
                                     "berlin/berlin-reinickendorf-2026.osm.pbf"};

// Always measured: villas whose chimneys had no room on roof planes without eaves.
constexpr std::int64_t kHouseIds[] = {572938068, 126977943};

// Largest spacing of samples.
constexpr double kApart_m = 2;

/// A building as a level shows it.
struct Level {
  std::vector<Corners> triangles;
  double error_m = 0;
};

Level level_of(const Building& building, const Rulebook& rulebook, double tolerance_m) {
  Report report;
  const GeneratedBuilding expanded = generate(building, rulebook, {1}, tolerance_m, report);
  Level level{{}, expanded.error_m};
  const auto add = [&](const materials::MaterialMesh& part) {
    const auto& p = part.mesh.positions;
    for (const auto& [a, b, c] : part.mesh.triangles) level.triangles.push_back({p[a], p[b], p[c]});
  };
  for (const auto& part : expanded.meshes) add(part);
  for (const auto& textured_faces : expanded.textured_faces) add(textured_faces.mesh);
  return level;
}

// Samples of vertices, edges and interior of a triangle in equal steps.
template <typename Visitor>
void each_sample(const Corners& t, Visitor with) {
  const double longest_m = std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
  const int steps = std::clamp(static_cast<int>(longest_m / kApart_m) + 1, 1, 24);
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      with(t.a + (t.b - t.a) * (static_cast<double>(i) / steps) + (t.c - t.a) * (static_cast<double>(j) / steps));
  with((t.a + t.b + t.c) * (1 / 3.0));
}

double farthest_m(const std::vector<Corners>& from, const NearestTriangle& to) {
  double most_m = 0;
  for (const Corners& t : from) each_sample(t, [&](Vec3 p) { most_m = std::max(most_m, to.distance_m(p, most_m)); });
  return most_m;
}

// Dropped buildings are measured against the ground.
double height_m_of(const Building& building, const Level& level) {
  double top_m = building.bottom_m;
  for (const Corners& t : level.triangles) top_m = std::max({top_m, t.a.z, t.b.z, t.c.z});
  return top_m - building.bottom_m;
}

double measured_m(const Building& building, const Level& finest, const NearestTriangle& to_finest, const Level& level) {
  if (level.triangles.empty()) return height_m_of(building, finest);
  return std::max(farthest_m(level.triangles, to_finest),
                  farthest_m(finest.triangles, NearestTriangle(level.triangles)));
}

/// Measures of all buildings on one level.
struct Row {
  std::size_t triangles = 0, dropped = 0;
  double stated_m = 0, measured_m = 0, share = 0;  ///< The largest; `share` of what both levels state.
};

// Without party walls, which only coarse levels contain.
Building with_party_walls_shown(Building building) {
  for (PartyWall& wall : building.party_walls) wall.is_hidden = false;
  return building;
}

void measure(const Building& building, const Rulebook& rulebook, std::span<Row> rows) {
  const Level finest = level_of(building, rulebook, kLadder_m[0]);
  const NearestTriangle to_finest(finest.triangles);
  for (std::size_t k = 0; k < std::size(kLadder_m); ++k) {
    const Level level = k == 0 ? finest : level_of(building, rulebook, kLadder_m[k]);
    const double measured = k == 0 ? 0 : measured_m(building, finest, to_finest, level);
    // vertices of roofs are rounded on each level
    const double stated_m = level.error_m + finest.error_m;
    EXPECT_LE(level.error_m, kLadder_m[k]) << to_string(building.id.osm);
    EXPECT_LE(measured, stated_m + kQuantum_m)
        << to_string(building.id.osm) << " " << rule_file_of(building.style) << " at " << kLadder_m[k] << " m";
    rows[k].triangles += level.triangles.size(), rows[k].dropped += level.triangles.empty();
    rows[k].stated_m = std::max(rows[k].stated_m, level.error_m);
    rows[k].measured_m = std::max(rows[k].measured_m, measured);
    if (stated_m > 0) rows[k].share = std::max(rows[k].share, measured / stated_m);
  }
}

// The number of buildings in CITYKILN_BUILDINGS, else a default.
std::size_t buildings_asked_for() {
  const char* asked = std::getenv("CITYKILN_BUILDINGS");
  return asked ? std::strtoul(asked, nullptr, 10) : 36;
}

TEST(CertifiedErrorReal, IsNeverLessThanWhatIsMeasured) {
  std::vector<Row> rows(std::size(kLadder_m));
  std::size_t measured = 0;
  const std::size_t from_each = std::max<std::size_t>(1, buildings_asked_for() / std::size(kExtracts));
  for (const char* extract : kExtracts) {
    if (!std::filesystem::exists(real_data(extract))) GTEST_SKIP() << "absent: " << extract;
    const std::vector<Building> buildings = buildings_in(extract);
    const Rulebook rulebook = parse_rulebook(shipped_rules());
    for (std::size_t i = 0; i < from_each && i < buildings.size(); ++i, ++measured)
      measure(with_party_walls_shown(buildings[i * buildings.size() / from_each]), rulebook, rows);
    for (const Building& building : buildings)
      if (std::ranges::count(kHouseIds, building.id.osm.id) > 0)
        measure(with_party_walls_shown(building), rulebook, rows), ++measured;
  }
  std::printf("%zu buildings\n", measured);
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::printf(
        "at %5g m: %9zu triangles, %4zu dropped, stated at most %7.4f m, measured at most %7.4f m, %.3f of what "
        "is stated\n",
        kLadder_m[k], rows[k].triangles, rows[k].dropped, rows[k].stated_m, rows[k].measured_m, rows[k].share);
}

}  // namespace
}  // namespace citykiln::buildings
