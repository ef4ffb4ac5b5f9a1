// Roofs over all buildings of real towns: as they are tagged, and of every form in turn.
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "compiler/contract/tolerance.h"
#include "grammars/roofs/generate_roof.h"
#include "tests/grammars/roofs/body.h"
#include "tests/grammars/roofs/real_footprints.h"
#include "tests/test_files.h"

namespace citykiln::roofs {
namespace {

struct Count {
  std::size_t roofs = 0, fallbacks = 0, open = 0, triangles = 0;
  double seconds = 0;
};

void tally(Count& count, const TaggedFootprint& building, RoofForm form) {
  RoofShape shape;
  shape.form = form;
  Report report;
  const auto start = std::chrono::steady_clock::now();
  const Roof roof = generate_roof(building.footprint, shape, 0.02, building.id.osm, report);
  count.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ++count.roofs;
  count.fallbacks += report.diagnoses().size();
  const Mesh body = closed_body(roof, -5);
  count.triangles += roof.triangles.size();
  const bool is_nothing = roof.triangles.empty() && !report.diagnoses().empty();
  const bool is_good = is_closed(body) && is_manifold_at_vertices(body) && (volume_m3(body) > 0 || is_nothing);
  count.open += !is_good;
  if (!is_good) std::printf("open: %s %s\n", to_string(building.id.osm).c_str(), std::string(name_of(form)).c_str());
}

void expect_roofs(const std::string& file) {
  const std::string path = real_data(file);
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  Count tagged, in_turn, hipped;
  std::size_t unknown = 0, next = 0;
  for (const TaggedFootprint& building : footprints_of(path)) {
    if (building.form) tally(tagged, building, *building.form);
    unknown += !building.tag.empty() && !building.form;
    tally(in_turn, building, static_cast<RoofForm>(next++ % static_cast<std::size_t>(RoofForm::kCount)));
    tally(hipped, building, RoofForm::kHipped);
  }
  EXPECT_GT(in_turn.roofs, 0u);
  for (const auto& [name, count] :
       {std::pair("as tagged", tagged), std::pair("in turn", in_turn), std::pair("hipped", hipped)})
    std::printf("%-40s %-9s %6zu roofs, %3zu flat instead (%.3f %%), %7zu triangles, %6.0f roofs/s\n", file.c_str(),
                name, count.roofs, count.fallbacks,
                100.0 * static_cast<double>(count.fallbacks) / std::max<double>(1, count.roofs), count.triangles,
                static_cast<double>(count.roofs) / std::max(1e-9, count.seconds));
  std::printf("%-40s %zu shapes of other names\n", file.c_str(), unknown);
  for (const Count& count : {tagged, in_turn, hipped}) {
    EXPECT_EQ(count.open, 0u);
    EXPECT_LT(static_cast<double>(count.fallbacks), 0.005 * static_cast<double>(count.roofs) + 1);
  }
}

TEST(RoofsReal, StandOnHelsinki) { expect_roofs("helsinki/Helsinki.osm.pbf"); }
TEST(RoofsReal, StandOnMonaco) { expect_roofs("monaco/monaco-2023.osm.pbf"); }
TEST(RoofsReal, StandOnMonacosCadastre) { expect_roofs("monaco/monaco-2016-cadastre.osm.pbf"); }
TEST(RoofsReal, StandOnNeubrandenburg) { expect_roofs("neubrandenburg/neubrandenburg.osm.bz2"); }
TEST(RoofsReal, StandOnReinickendorf) { expect_roofs("berlin/berlin-reinickendorf-2026.osm.pbf"); }
TEST(RoofsReal, StandOnGesundbrunnen) { expect_roofs("berlin/berlin-mitte-gesundbrunnen.osm"); }

// The roofs at 0.5 m compared with those at 0.02 m.
TEST(RoofsReal, StayWithinTheErrorTheyState) {
  const std::string path = real_data("berlin/berlin-mitte-gesundbrunnen.osm");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "absent: " << path;
  std::size_t next = 0, fine_triangles = 0, coarse_triangles = 0;
  for (const TaggedFootprint& building : footprints_of(path)) {
    RoofShape shape;
    shape.form = static_cast<RoofForm>(next++ % static_cast<std::size_t>(RoofForm::kCount));
    Report report;
    const Roof fine = generate_roof(building.footprint, shape, 0.02, building.id.osm, report);
    const Roof coarse = generate_roof(building.footprint, shape, 0.5, building.id.osm, report);
    fine_triangles += fine.triangles.size(), coarse_triangles += coarse.triangles.size();
    if (fine.triangles.size() > 1000) continue;
    const Mesh a = closed_body(fine, -5), b = closed_body(coarse, -5);
    EXPECT_LE(std::max(distance_m(a, b), distance_m(b, a)), fine.error_m + coarse.error_m + 4 * kQuantum_m)
        << to_string(building.id.osm) << ' ' << name_of(shape.form);
  }
  EXPECT_GT(coarse_triangles, 0u);
  std::printf("at 0.02 m %zu triangles, at 0.5 m %zu\n", fine_triangles, coarse_triangles);
}

std::size_t corners_of_building(const TaggedFootprint& building) {
  std::size_t count = building.footprint.outer.size();
  for (const Ring& ring : building.footprint.holes) count += ring.size();
  return count;
}

// Every form on the building with the most corners in a town, and on an outline with 400 corners.
TEST(RoofsReal, StandOnFourHundredCorners) {
  const std::string path = real_data("helsinki/Helsinki.osm.pbf");
  const std::string lakes = real_data("andorra/andorra-2023.osm.pbf");
  if (!std::filesystem::exists(path) || !std::filesystem::exists(lakes)) GTEST_SKIP() << "absent: " << path;
  std::vector<TaggedFootprint> all = footprints_of(path);
  const auto largest = std::max_element(all.begin(), all.end(), [](const TaggedFootprint& a, const TaggedFootprint& b) {
    return corners_of_building(a) < corners_of_building(b);
  });
  const TaggedFootprint outline{{}, outline_of(lakes, 400), {}, ""};
  for (const TaggedFootprint& building : {*largest, outline}) {
    std::printf("%s: %zu corners\n", to_string(building.id.osm).c_str(), corners_of_building(building));
    for (int form = 0; form < static_cast<int>(RoofForm::kCount); ++form) {
      Count count;
      tally(count, building, static_cast<RoofForm>(form));
      EXPECT_EQ(count.open, 0u);
      EXPECT_EQ(count.fallbacks, 0u);
      std::printf("  %-15s %zu triangles, %zu flat instead, %.0f ms\n",
                  std::string(name_of(static_cast<RoofForm>(form))).c_str(), count.triangles, count.fallbacks,
                  1000 * count.seconds);
    }
  }
}

}  // namespace
}  // namespace citykiln::roofs
