// The real heightmaps of ../shared/data: the same place in every format.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "compiler/source/read_raster.h"
#include "compiler/source/voids/blocks_to_voids.h"
#include "compiler/source/voids/codes_to_voids.h"
#include "compiler/source/voids/fill_gaps.h"
#include "compiler/source/voids/spikes_to_voids.h"
#include "tests/compiler/source/extract_text.h"
#include "tests/test_files.h"

namespace citykiln::source {
namespace {

namespace fs = std::filesystem;

Raster read_real(const std::string& spec_text, const LonLatBox* window = nullptr) {
  const Result<RasterSpec> spec = parse_raster_spec(real_data(spec_text).string());
  if (!spec) {
    ADD_FAILURE() << to_string(spec.error());
    return {};
  }
  Result<Raster> raster = read_raster(*spec, window);
  if (!raster) {
    ADD_FAILURE() << to_string(raster.error());
    return {};
  }
  return std::move(*raster);
}

struct RasterReal : testing::Test {
  void SetUp() override {
    if (!fs::exists(real_data("dem-derived"))) GTEST_SKIP() << "no heightmaps in " << real_data();
  }
};

// Interpolated between the four samples around; NaN outside.
class Sampler {
 public:
  explicit Sampler(const Raster& raster) : raster_(raster), to_system_(*to_system_of(raster)) {}

  double height_m(double lon, double lat) const {
    to_system_(lon, lat);
    const auto& a = raster_.from_grid;
    const double x = (lon - a[0]) / a[1], y = (lat - a[3]) / a[5];
    const int c = static_cast<int>(std::floor(x)), r = static_cast<int>(std::floor(y));
    if (c < 0 || r < 0 || c + 1 >= raster_.columns || r + 1 >= raster_.rows) return NAN;
    const double u = x - c, v = y - r;
    return (1 - v) * ((1 - u) * raster_.at(c, r) + u * raster_.at(c + 1, r)) +
           v * ((1 - u) * raster_.at(c, r + 1) + u * raster_.at(c + 1, r + 1));
  }

 private:
  const Raster& raster_;
  ToRasterSystem to_system_;
};

struct Agreement {
  int compared = 0;
  double mean_m = 0, median_m = 0, largest_m = 0, bias_m = 0;
};

// Compares at the nodes of a lattice in `box`.
Agreement compare(const Raster& a, const Raster& b, const LonLatBox& box, int steps = 150) {
  const Sampler sample_a(a), sample_b(b);
  std::vector<double> errors_m;
  double sum = 0;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      const double lon = box.west + (box.east - box.west) * i / steps,
                   lat = box.south + (box.north - box.south) * j / steps;
      const double error_m = sample_a.height_m(lon, lat) - sample_b.height_m(lon, lat);
      if (std::isnan(error_m)) continue;
      errors_m.push_back(std::abs(error_m));
      sum += error_m;
    }
  }
  if (errors_m.empty()) return {};
  std::sort(errors_m.begin(), errors_m.end());
  const auto count = static_cast<double>(errors_m.size());
  return {static_cast<int>(errors_m.size()), std::accumulate(errors_m.begin(), errors_m.end(), 0.0) / count,
          errors_m[errors_m.size() / 2], errors_m.back(), sum / count};
}

Raster filled(Raster raster) {
  Report report;
  return fill_voids(std::move(raster), report);
}

// The format agrees with the .hgt it was made from: within `mean_m` on average and `largest_m` everywhere (resampling
// moves heights on steep slopes), and without bias, which a shift by half a pixel would not have on a valley's one
// side.
void expect_agreement(const Raster& ours, const Raster& hgt, const LonLatBox& box, double mean_m, double largest_m) {
  const Agreement agreement = compare(ours, hgt, box);
  const std::string text =
      fmt::format("{}: {} points, mean {:.3f} m, median {:.3f} m, largest {:.2f} m, bias {:.3f} m", ours.file_name,
                  agreement.compared, agreement.mean_m, agreement.median_m, agreement.largest_m, agreement.bias_m);
  EXPECT_GT(agreement.compared, 1000) << text;
  EXPECT_LT(agreement.mean_m, mean_m) << text;
  EXPECT_LT(agreement.largest_m, largest_m) << text;
  EXPECT_LT(std::abs(agreement.bias_m), 0.1 * mean_m + 0.02) << text;
}

TEST_F(RasterReal, SamePlaceInEveryFormatAgrees) {
  const LonLatBox andorra{1.42, 42.44, 1.78, 42.65};
  const Raster hgt = filled(read_real("andorra/N42E001.hgt", &andorra));
  expect_agreement(filled(read_real("dem-derived/andorra-wgs84.asc")), hgt, andorra, 0.01, 0.01);
  // resampled to 60 m
  expect_agreement(filled(read_real("dem-derived/andorra-centre-utm31-float-deflate-tiled.tif")), hgt, andorra, 2, 25);
  // cut at whole samples: the box in its name is off by half a sample. Its voids are filled another way
  expect_agreement(read_real("dem-derived/andorra-16bit-metres-lon1.40-1.80-lat42.42-42.67.png,"
                             "bounds=1.399583333333/42.420416666667/1.799583333333/42.670416666667"),
                   hgt, andorra, 0.2, 60);
  for (const auto& [x, y] : {std::pair{2065, 1512}, std::pair{2066, 1511}}) {
    const std::string tile =
        fmt::format("dem-derived/andorra-terrarium-z12-x{0}-y{1}.png,encoding=terrarium,tile=12/{0}/{1}", x, y);
    expect_agreement(read_real(tile), hgt, andorra, 0.4, 60);
  }
}

TEST_F(RasterReal, MonacoTiffHoldsTheSamplesOfItsHgt) {
  const Raster tif = read_real("dem-derived/monaco-wgs84-int16-lzw.tif");
  const Raster hgt = read_real("monaco/N43E007.hgt");
  const LonLatBox monaco{7.3, 43.65, 7.5, 43.8};
  expect_agreement(tif, hgt, monaco, 0.01, 0.01);
}

TEST_F(RasterReal, WindowHoldsTheSamplesOfTheWhole) {
  const LonLatBox box{1.5, 42.49, 1.55, 42.52};
  const Raster whole = read_real("andorra/N42E001.hgt"), window = read_real("andorra/N42E001.hgt", &box);
  EXPECT_LT(window.columns, 120);
  EXPECT_GT(window.columns, 60);
  const Agreement agreement = compare(window, whole, box);
  EXPECT_GT(agreement.compared, 20000);
  EXPECT_LT(agreement.largest_m, 1e-6);
}

TEST_F(RasterReal, HgtSamplesLieOnWholeArcSeconds) {
  const Raster hgt = read_real("andorra/N42E001.hgt");
  EXPECT_EQ(hgt.columns, 1201);
  EXPECT_NEAR(hgt.from_grid[0], 1, 1e-9);
  EXPECT_NEAR(hgt.from_grid[3], 43, 1e-9);
  EXPECT_NEAR(hgt.from_grid[1], 1.0 / 1200, 1e-12);
  EXPECT_EQ(hgt.system_wkt, "");
  // 3 seconds of longitude at 42.5 degrees, and of latitude
  EXPECT_NEAR(hgt.spacing_m.x, 68.4, 0.5);
  EXPECT_NEAR(hgt.spacing_m.y, 92.6, 0.5);
}

TEST_F(RasterReal, SrtmVoidsAreFoundAndFilledWithinTheirSurroundings) {
  const Raster hgt = read_real("andorra/N42E001.hgt");
  const auto is_void = [](float height) { return std::isnan(height); };
  EXPECT_EQ(std::count_if(hgt.heights_m.begin(), hgt.heights_m.end(), is_void), 7652);
  const Raster full = filled(hgt);
  EXPECT_EQ(std::count_if(full.heights_m.begin(), full.heights_m.end(), is_void), 0);
  EXPECT_LE(*std::max_element(full.heights_m.begin(), full.heights_m.end()), 3100);
  EXPECT_GE(*std::min_element(full.heights_m.begin(), full.heights_m.end()), 0);
}

TEST_F(RasterReal, ReadsZippedHgt) {
  const Raster raster = read_real("dem-formats/N48W125-srtm1.hgt.zip");
  EXPECT_EQ(raster.columns, 3601);
  EXPECT_EQ(raster.rows, 3601);
  EXPECT_NEAR(raster.from_grid[0], -125, 1e-9);
}

TEST_F(RasterReal, NeighbouringRastersShareOneGridAndMeet) {
  const Raster west = read_real("dem-formats/elevation1.tif"), east = read_real("dem-formats/elevation2.tif");
  const double step = west.from_grid[1];
  EXPECT_NEAR(east.from_grid[1], step, 1e-12);
  const double columns_apart = (east.from_grid[0] - west.from_grid[0]) / step;
  const double rows_apart = (east.from_grid[3] - west.from_grid[3]) / step;
  EXPECT_NEAR(columns_apart, std::round(columns_apart), 1e-6);
  EXPECT_NEAR(rows_apart, std::round(rows_apart), 1e-6);
  EXPECT_TRUE(std::round(std::abs(columns_apart)) <= west.columns && std::round(std::abs(rows_apart)) <= west.rows)
      << columns_apart << " " << rows_apart;
}

struct Expected {
  const char* spec;
  double low_m, high_m;
};

TEST_F(RasterReal, HeightsOfEveryFileAreThoseOfItsPlace) {
  constexpr Expected kFiles[] = {
      {"monaco/N43E007.hgt", -11, 2064},
      {"berlin/N52E013.hgt", -37, 184},
      {"dem-formats/N57E011.hgt", -6, 163},
      {"portland/portland-ned.tif", 0, 328},
      {"porto-alegre/poa_elevation.tif", 0, 255},
      {"dem-formats/fuji-mapbox-terrain-rgb.png,encoding=mapbox,bounds=138.69/35.32/138.78/35.39", 13.7, 3751},
      {"dem-formats/terrarium-mapzen-unknown-place.png,encoding=terrarium,bounds=0/0/1/1", 852.1, 2475.1},
      {"dem-formats/qgis-dem.tif", 85, 243},
      {"dem-formats/qgis-analysis-dem-laea.tif", 1586, 3214},
      {"dem-formats/terra-luxembourg-elev.tif", 141, 547},
      {"dem-formats/elevation1.tif", -35, 118},
      {"dem-formats/elevation2.tif", -35, 118},
      {"dem-formats/capetown-LO19_050M_3318CD.tif", -15.7, 1106},
  };
  for (const Expected& file : kFiles) {
    const Raster raster = read_real(file.spec);
    ASSERT_GT(raster.columns, 0) << file.spec;
    const Raster full = filled(raster);
    const auto [low, high] = std::minmax_element(full.heights_m.begin(), full.heights_m.end());
    EXPECT_GE(*low, file.low_m - 1) << file.spec;
    EXPECT_LE(*high, file.high_m + 1) << file.spec;
    EXPECT_GT(std::min(raster.spacing_m.x, raster.spacing_m.y), 1) << file.spec;
  }
}

TEST_F(RasterReal, CutFilesAreErrors) {
  for (const char* file :
       {"portland/portland-ned.tif", "dem-formats/fuji-mapbox-terrain-rgb.png", "andorra/N42E001.hgt"}) {
    const std::string whole = bytes_of(real_data(file));
    const ScratchFolder folder;
    RasterSpec spec;
    spec.path = folder.write(fs::path(file).filename().string(), whole.substr(0, whole.size() / 2));
    spec.bounds = LonLatBox{0, 0, 1, 1};
    if (std::string_view(file).ends_with(".png")) spec.encoding = "mapbox";
    const Result<Raster> raster = read_raster(spec, nullptr);
    EXPECT_FALSE(raster) << file;
  }
}

TEST_F(RasterReal, PictureWithoutPlaceOrEncodingIsAnError) {
  const auto error_of = [](const std::string& text) {
    const Result<Raster> raster = read_raster(*parse_raster_spec(real_data(text).string()), nullptr);
    return raster ? "no error" : raster.error().message;
  };
  EXPECT_EQ(error_of("dem-formats/fuji-mapbox-terrain-rgb.png,encoding=mapbox"),
            "the file has no georeference; add bounds=W/S/E/N or tile=Z/X/Y");
  EXPECT_EQ(error_of("dem-formats/fuji-mapbox-terrain-rgb.png,bounds=0/0/1/1"),
            "a colour picture needs encoding=terrarium or encoding=mapbox");
  EXPECT_EQ(error_of("portland/portland-ned.tif,encoding=terrarium"),
            "encoding=terrarium needs three bands with 8 bits each");
}

// Each of these was judged by eye in its surroundings. All other samples are real terrain, such as cliffs and sea
// stacks.
TEST_F(RasterReal, SpikesAreFoundAndNoNaturalPlaceIs) {
  const auto spikes = [](const std::string& spec) {
    Report report;
    std::vector<std::pair<int, int>> places;
    const Raster raster = read_real(spec), mended = spikes_to_voids(raster, report);
    for (int row = 0; row < raster.rows; ++row) {
      for (int column = 0; column < raster.columns; ++column) {
        if (std::isnan(mended.at(column, row)) && !std::isnan(raster.at(column, row))) places.emplace_back(column, row);
      }
    }
    return places;
  };
  using Places = std::vector<std::pair<int, int>>;
  // pits of 55 m, and of 260 m in two samples
  EXPECT_EQ(spikes("andorra/N42E001.hgt"), (Places{{84, 261}, {845, 913}, {846, 913}}));
  // 0 m in the middle of 22 m
  EXPECT_EQ(spikes("portland/portland-ned.tif"), (Places{{469, 222}}));
  for (const std::string clean :
       {"monaco/N43E007.hgt", "berlin/N52E013.hgt", "dem-formats/N57E011.hgt", "dem-formats/N48W125-srtm1.hgt.zip",
        "porto-alegre/poa_elevation.tif", "dem-formats/capetown-LO19_050M_3318CD.tif",
        "dem-formats/fuji-mapbox-terrain-rgb.png,encoding=mapbox,tile=10/906/404"}) {
    EXPECT_TRUE(spikes(clean).empty()) << clean;
  }
}

TEST_F(RasterReal, OnlyBlocksOfZerosArePlacesThatNobodyPlanted) {
  for (const std::string spec :
       {"andorra/N42E001.hgt", "monaco/N43E007.hgt", "berlin/N52E013.hgt", "st-moritz/N46E009.hgt.zip",
        "liechtenstein/N47E009.hgt.zip", "portland/portland-ned.tif", "porto-alegre/poa_elevation.tif",
        "dem-formats/N57E011.hgt", "dem-formats/N48W125-srtm1.hgt.zip", "dem-formats/qgis-analysis-dem-laea.tif",
        "dem-formats/capetown-LO19_050M_3318CD.tif",
        "dem-formats/fuji-mapbox-terrain-rgb.png,encoding=mapbox,tile=10/906/404"}) {
    Report spikes, natural, planted;
    const Raster land = spikes_to_voids(read_real(spec), spikes);
    blocks_to_voids(land, natural);
    // two by three samples with 0 m in the middle of 14 m, and three of 11 m
    EXPECT_EQ(natural.diagnoses().size(), spec.starts_with("portland/") ? 2u : 0u) << spec;
    Raster broken = land;
    std::size_t blocks = natural.diagnoses().size();
    for (int row = 20; row + 20 < land.rows; row += 40) {
      for (int column = 20; column + 20 < land.columns; column += 40) {
        if (std::isnan(land.at(column, row))) continue;
        ++blocks;
        for (int i = 0; i < 12; ++i)
          broken.heights_m[static_cast<std::size_t>(row + i / 4) * land.columns + column + i % 4] += 1000;
      }
    }
    blocks_to_voids(broken, planted);
    EXPECT_GE(planted.diagnoses().size(), blocks - blocks / 20) << spec;
  }
}

TEST_F(RasterReal, NoRealHeightIsTakenForAValueThatStandsForNone) {
  for (const char* name :
       {"andorra/N42E001.hgt", "monaco/N43E007.hgt", "berlin/N52E013.hgt", "portland/portland-ned.tif",
        "porto-alegre/poa_elevation.tif", "dem-formats/N48W125-srtm1.hgt.zip", "dem-formats/N57E011.hgt",
        "dem-formats/elevation1.tif", "dem-formats/elevation2.tif", "dem-formats/qgis-dem.tif",
        "dem-formats/qgis-analysis-dem-laea.tif", "dem-formats/terra-luxembourg-elev.tif",
        "dem-formats/capetown-LO19_050M_3318CD.tif"}) {
    Report report;
    const Raster raster = codes_to_voids(read_real(name), report);
    for (const Diagnosis& found : report.diagnoses()) ADD_FAILURE() << name << " " << found.tag << " " << found.size;
    EXPECT_FALSE(first_height_off_land(raster)) << name;
  }
}

}  // namespace
}  // namespace citykiln::source
