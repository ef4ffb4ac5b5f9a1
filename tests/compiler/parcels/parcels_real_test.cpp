// Parcels of real extracts: their properties, and a line of figures for each.
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <set>

#include "compiler/parcels/divide.h"
#include "tests/compiler/parcels/made_land.h"
#include "tests/compiler/parcels/real_land.h"
#include "tests/test_files.h"

namespace citykiln::parcels {
namespace {

void print_figures(const std::string& name, const Land& land, const Parcels& parcels, double seconds) {
  std::array<int, static_cast<std::size_t>(Cause::kCount)> causes{};
  for (const Failure& failure : parcels.failures) ++causes[static_cast<std::size_t>(failure.cause)];
  std::printf(
      "%-28s %6zu lines %6zu blocks %6zu lots of %6zu buildings; failures: line %d, taken %d, outside %d, "
      "far %d, no street %d, no area %d; %.1f s\n",
      name.c_str(), land.lines.size(), parcels.blocks.size(), parcels.lots.size(), land.footprints.size(), causes[0],
      causes[1], causes[2], causes[3], causes[4], causes[5], seconds);
}

class ParcelsReal : public testing::TestWithParam<const char*> {};

TEST_P(ParcelsReal, HaveTheProperties) {
  const std::filesystem::path path = real_data(GetParam());
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const Land land = land_of_file(path);
  const auto start = std::chrono::steady_clock::now();
  const Parcels parcels = divide(land, 0);
  print_figures(GetParam(), land, parcels,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  EXPECT_FALSE(parcels.blocks.empty());
  expect_properties(land, parcels, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Places, ParcelsReal,
                         testing::Values("limerick/limerick.osm.gz", "los-angeles-north-hills/north-hills.osm.gz",
                                         "boston-back-bay/back_bay.osm.pbf", "andorra/andorra-2023.osm.pbf",
                                         "porto-roads/porto_portugal.osm.pbf"));

TEST(ParcelsRealJunctions, HaveTheProperties) {
  const std::filesystem::path folder = real_data("junctions");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.insert(entry.path());
  for (const auto& file : files) {
    const Land land = land_of_file(file);
    expect_properties(land, divide(land, 0), file.filename().string());
  }
}

}  // namespace
}  // namespace citykiln::parcels
