// Real heightmaps without most of their samples: those left out lie within the stated error.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/correction/heightmap_error.h"
#include "compiler/map/plane/smooth_land.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/test_files.h"

namespace citykiln::ground {
namespace {

struct HeightmapErrorReal : testing::TestWithParam<std::string> {
  void SetUp() override {
    if (!std::filesystem::exists(real_data(GetParam()))) GTEST_SKIP() << "no heightmap in " << real_data();
  }

  source::Raster read() {
    const auto spec = source::parse_raster_spec(real_data(GetParam()).string());
    auto raster = spec ? source::read_raster(*spec, nullptr) : Result<source::Raster>(spec.error());
    if (!raster) ADD_FAILURE() << to_string(raster.error());
    Report report;
    return raster ? source::fill_voids(std::move(*raster), report) : source::Raster{};
  }
};

// Every n-th sample, 90 n metres apart.
map::Heightfield thinned_field(const source::Raster& raster, int n) {
  const int columns = (raster.columns - 1) / n + 1, rows = (raster.rows - 1) / n + 1;
  map::Heightfield field{{0, 0}, {90.0 * n, 90.0 * n}, columns, rows, {}, 0};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      field.heights.push_back(static_cast<std::int32_t>(raster.at(i * n, j * n) / map::kHeightQuantum_m));
  return map::smooth_land(std::move(field), 4);
}

TEST_P(HeightmapErrorReal, HoldsForSamplesThatAreLeftOut) {
  const source::Raster raster = read();
  const RandomSequence draw(7, StableId{1}, "samples");
  for (const int n : {2, 3, 4}) {
    const map::Heightfield field = thinned_field(raster, n);
    std::uint32_t within = 0, count = 0;
    double errors_m = 0;
    for (std::uint32_t k = 0; k < 40'000; ++k) {
      const auto column = static_cast<int>(draw.between(3.0 * n, raster.columns - 3.0 * n, 2 * k)),
                 row = static_cast<int>(draw.between(3.0 * n, raster.rows - 3.0 * n, 2 * k + 1));
      if (column % n == 0 && row % n == 0) continue;
      const Vec2 at{90.0 * column, 90.0 * row};
      const double error_m = heightmap_error_m(field, at);
      within += std::abs(height_m_at(field, at) - raster.at(column, row)) <= error_m;
      errors_m += error_m, ++count;
    }
    fmt::print("every {}: {:.2f} % within, {:.1f} m on average\n", n, 100.0 * within / count, errors_m / count);
    EXPECT_GT(within, 0.985 * count) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Places, HeightmapErrorReal,
                         testing::Values("andorra/N42E001.hgt", "st-moritz/N46E009.hgt.zip",
                                         "liechtenstein/N47E009.hgt.zip", "monaco/N43E007.hgt", "berlin/N52E013.hgt"));

}  // namespace
}  // namespace citykiln::ground
