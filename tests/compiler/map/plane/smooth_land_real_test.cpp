#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "compiler/map/plane/bicubic.h"
#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "tests/test_files.h"

namespace citykiln::map {
namespace {

struct SquaredErrors {
  double smooth_m2 = 0, bilinear_m2 = 0;
};

// Errors at the samples of a heightmap that thinning by n leaves out.
SquaredErrors errors_of_thinned(const source::Raster& raster, int n) {
  SquaredErrors errors;
  for (int r = n; r + 3 * n < raster.rows; ++r)
    for (int c = n; c + 3 * n < raster.columns; ++c) {
      const int column = c / n * n, row = r / n * n;
      const auto at = [&](int i, int j) { return double{raster.at(column + i * n, row + j * n)}; };
      const double u = double{1} * (c - column) / n, v = double{1} * (r - row) / n, z = raster.at(c, r);
      const double smooth = smooth_height<double>(at, u, v) - z;
      const double bilinear =
          (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v - z;
      errors.smooth_m2 += smooth * smooth, errors.bilinear_m2 += bilinear * bilinear;
    }
  return errors;
}

// Berlin is nearly level; what its samples show is mostly houses and trees of the size of a sample.
TEST(SmoothLandReal, SamplesLeftOutAreNearerThanToBilinearHeightsInMountainsAndAsNearInBerlin) {
  if (!std::filesystem::exists(real_data())) GTEST_SKIP() << "no real data at " << real_data();
  const source::LonLatBox andorra{1.4, 42.4, 1.8, 42.7}, berlin{13.2, 52.3, 13.6, 52.6};
  const struct {
    const char* path;
    const source::LonLatBox& window;
    double most;  // share of the bilinear r.m.s.
  } cases[] = {{"andorra/N42E001.hgt", andorra, 0.95}, {"berlin/N52E013.hgt", berlin, 1.01}};
  for (const auto& c : cases)
    for (const int n : {2, 4}) {
      source::RasterSpec spec;
      spec.path = real_data(c.path);
      const auto raster = source::read_raster(spec, &c.window);
      ASSERT_TRUE(raster) << c.path;
      Report ignored;
      const SquaredErrors errors = errors_of_thinned(source::fill_voids(*raster, ignored), n);
      EXPECT_LE(std::sqrt(errors.smooth_m2), c.most * std::sqrt(errors.bilinear_m2)) << c.path << " " << n;
    }
}

}  // namespace
}  // namespace citykiln::map
