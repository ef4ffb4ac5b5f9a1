#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "compiler/source/read_raster.h"
#include "compiler/source/voids/fill_gaps.h"
#include "compiler/source/voids/spikes_to_voids.h"
#include "tests/compiler/source/extract_text.h"

namespace citykiln::source {
namespace {

std::string error_of_spec(std::string_view text) {
  const Result<RasterSpec> spec = parse_raster_spec(text);
  return spec ? "no error" : to_string(spec.error());
}

TEST(ParseRasterSpec, ReadsEveryKey) {
  const Result<RasterSpec> spec = parse_raster_spec(
      "a.png,bounds=1.5/42/2/43,scale=0.1,offset=-7,encoding=mapbox,tile=12/2065/1512,credit=Someone");
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->path, "a.png");
  EXPECT_EQ(spec->bounds, (LonLatBox{1.5, 42, 2, 43}));
  EXPECT_EQ(spec->scale, 0.1);
  EXPECT_EQ(spec->offset_m, -7);
  EXPECT_EQ(spec->encoding, "mapbox");
  EXPECT_EQ(spec->tile_zxy, (std::array{12, 2065, 1512}));
  EXPECT_EQ(spec->credit, "Someone");
}

TEST(ParseRasterSpec, OffsetAutoAndUnitsAreRead) {
  EXPECT_TRUE(parse_raster_spec("a.tif,offset=auto")->is_fitted);
  EXPECT_EQ(parse_raster_spec("a.tif,unit=Feet")->unit_m, 0.3048);
  EXPECT_EQ(parse_raster_spec("a.tif,unit=us-ft")->unit_m, 1200.0 / 3937);
  for (const char* unit : {"m2", "0.3048 m", "\u00b5m"})
    EXPECT_FALSE(error_of_spec(std::string("a.tif,unit=") + unit).empty()) << unit;
  EXPECT_EQ(error_of_spec("a.tif,unit=ell"), "a.tif: expected a unit, such as m, ft or us-ft after unit=, found 'ell'");
  EXPECT_EQ(error_of_spec("a.tif,offset=up"), "a.tif: expected a number or auto after offset=, found 'up'");
}

TEST(ParseRasterSpec, TheNameOfAFileMayHaveCommas) {
  const ScratchFolder folder;
  const std::string path = folder.write("a, b,scale=2.tif", "x");
  EXPECT_EQ(parse_raster_spec(path)->path, path);
  const Result<RasterSpec> with_key = parse_raster_spec(path + ",scale=3");
  ASSERT_TRUE(with_key);
  EXPECT_EQ(with_key->path, path);
  EXPECT_EQ(with_key->scale, 3);
}

TEST(ParseRasterSpec, TakesAFileWithoutKeys) {
  const Result<RasterSpec> spec = parse_raster_spec("N42E001.hgt");
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->path, "N42E001.hgt");
  EXPECT_EQ(spec->scale, 1);
}

TEST(ParseRasterSpec, ErrorsNameTheKeyAndTheValue) {
  EXPECT_EQ(error_of_spec("a.png,colour=red"),
            "a.png: unknown key 'colour'; expected one of bounds, scale, offset, unit, encoding, tile, credit");
  EXPECT_EQ(error_of_spec("a.png,scale=big"), "a.png: expected a number after scale=, found 'big'");
  EXPECT_EQ(error_of_spec("a.png,scale=1m"), "a.png: expected a number after scale=, found '1m'");
  EXPECT_EQ(error_of_spec("a.png,bounds=1/2/3"), "a.png: expected W/S/E/N in degrees after bounds=, found '1/2/3'");
  EXPECT_EQ(error_of_spec("a.png,bounds=2/42/1/43"),
            "a.png: expected W/S/E/N in degrees with west < east and south < north after bounds=, found '2/42/1/43'");
  EXPECT_EQ(error_of_spec("a.png,tile=3/8/0"),
            "a.png: expected Z/X/Y with X and Y below 2^Z after tile=, found '3/8/0'");
  EXPECT_EQ(error_of_spec("a.png,encoding=png"), "a.png: expected terrarium or mapbox after encoding=, found 'png'");
  EXPECT_EQ(error_of_spec("a.png,flat"), "a.png: expected key=value, found 'flat'");
  EXPECT_EQ(error_of_spec(""), "expected the file name of a heightmap first, such as N43E007.hgt");
}

Raster raster_of_samples(int columns, int rows, const std::function<float(int, int)>& height) {
  Raster raster;
  raster.columns = columns;
  raster.rows = rows;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) raster.heights_m.push_back(height(column, row));
  }
  return raster;
}

TEST(FillVoids, HoleInAPlaneIsFilledWithThePlane) {
  const auto plane = [](int column, int row) { return 100 + 3.0F * column - 2.0F * row; };
  const auto is_hole = [](int column, int row) {
    return column > 5 && column < 60 && row > 3 && row < 40 && column + row < 80;
  };
  Report report;
  const Raster filled =
      fill_voids(raster_of_samples(70, 50, [&](int c, int r) { return is_hole(c, r) ? kVoid : plane(c, r); }), report);
  for (int r = 0; r < 50; ++r) {
    for (int c = 0; c < 70; ++c) EXPECT_NEAR(filled.at(c, r), plane(c, r), 0.05) << c << " " << r;
  }
}

TEST(FillVoids, FilledHeightsStayWithinTheRim) {
  Report report;
  const auto bumpy = [](int c, int r) { return static_cast<float>((c * 37 + r * 101) % 53); };
  const auto is_hole = [](int c, int r) { return c % 40 > 4 && r % 30 > 7; };
  const Raster filled =
      fill_voids(raster_of_samples(120, 90, [&](int c, int r) { return is_hole(c, r) ? kVoid : bumpy(c, r); }), report);
  ASSERT_EQ(filled.heights_m.size(), 120u * 90u);
  for (const float height : filled.heights_m) {
    EXPECT_GE(height, 0.0F);
    EXPECT_LE(height, 52.0F);
  }
}

TEST(FillVoids, EachFilledSampleIsTheMeanOfItsNeighbours) {
  Report report;
  const auto is_hole = [](int c, int r) { return (c - 30) * (c - 30) + (r - 30) * (r - 30) < 400; };
  const Raster filled = fill_voids(
      raster_of_samples(61, 61, [&](int c, int r) { return is_hole(c, r) ? kVoid : static_cast<float>(c * r % 97); }),
      report);
  for (int r = 1; r < 60; ++r) {
    for (int c = 1; c < 60; ++c) {
      if (!is_hole(c, r)) continue;
      const float mean = (filled.at(c - 1, r) + filled.at(c + 1, r) + filled.at(c, r - 1) + filled.at(c, r + 1)) / 4;
      EXPECT_NEAR(filled.at(c, r), mean, 1e-3);
    }
  }
}

TEST(FillVoids, SamplesThatAreThereStay) {
  Report report;
  const Raster raster =
      raster_of_samples(9, 7, [](int c, int r) { return c == 4 && r > 1 ? kVoid : static_cast<float>(c * r); });
  const Raster filled = fill_voids(raster, report);
  ASSERT_EQ(filled.heights_m.size(), 63u);
  for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
    EXPECT_TRUE(std::isnan(raster.heights_m[i]) || filled.heights_m[i] == raster.heights_m[i]) << i;
  }
}

TEST(FillVoids, WithoutARimTheGroundIsAtZero) {
  Report report;
  const Raster filled = fill_voids(raster_of_samples(5, 4, [](int, int) { return kVoid; }), report);
  EXPECT_EQ(filled.heights_m, std::vector<float>(20, 0.0F));
}

TEST(FillVoids, NumberOfSamplesIsDiagnosed) {
  Report report, none;
  fill_voids(raster_of_samples(5, 4, [](int c, int) { return c < 2 ? kVoid : 1.0F; }), report);
  ASSERT_EQ(report.diagnoses().size(), 1u);
  EXPECT_EQ(report.diagnoses()[0].code, Code::kVoidFilled);
  EXPECT_EQ(report.diagnoses()[0].size, 8);
  fill_voids(raster_of_samples(5, 4, [](int, int) { return 1.0F; }), none);
  EXPECT_TRUE(none.diagnoses().empty());
}

TEST(FillVoids, AcceptsRastersWithoutSamples) {
  Report report;
  EXPECT_TRUE(fill_voids(Raster{}, report).heights_m.empty());
}

// ---- files written here

constexpr std::string_view kAscii =
    "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 50\ncellsize 0.5\nNODATA_value -9999\n1 2 3\n4 -9999 6\n";

std::string raster_error_of(const std::string& name, std::string_view bytes, const std::string& more = "") {
  const ScratchFolder folder;
  const std::string path = folder.write(name, bytes);
  const Result<RasterSpec> spec = parse_raster_spec(path + more);
  if (!spec) return to_string(spec.error());
  const Result<Raster> raster = read_raster(*spec, nullptr);
  if (raster) return "no error";
  const std::string line = to_string(raster.error());
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  return line.starts_with(path) ? line.substr(path.size()) : line;
}

Raster read_ascii(std::string_view text, const RasterSpec& how = {}, const LonLatBox* window = nullptr) {
  const ScratchFolder folder;
  RasterSpec spec = how;
  spec.path = folder.write("a.asc", text);
  Result<Raster> raster = read_raster(spec, window);
  if (!raster) {
    ADD_FAILURE() << to_string(raster.error());
    return {};
  }
  return std::move(*raster);
}

TEST(ReadRaster, SamplesLieAtTheMiddleOfCellsAndRowZeroIsNorth) {
  const Raster raster = read_ascii(kAscii);
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 2);
  EXPECT_EQ(raster.at(0, 0), 1);
  EXPECT_EQ(raster.at(2, 1), 6);
  EXPECT_EQ(raster.from_grid, (std::array<double, 6>{10.25, 0.5, 0, 50.75, 0, -0.5}));
  EXPECT_EQ(raster.system_wkt, "");
}

TEST(ReadRaster, NodataIsNotANumber) {
  EXPECT_TRUE(std::isnan(read_ascii(kAscii).at(1, 1)));
  EXPECT_TRUE(
      std::isnan(read_ascii("ncols 2\nnrows 1\nxllcorner 10\nyllcorner 50\ncellsize 0.5\n-32768 1\n").at(0, 0)));
}

TEST(ReadRaster, ScaleAndOffsetMakeMetres) {
  RasterSpec how;
  how.scale = 0.5;
  how.offset_m = 100;
  const Raster raster = read_ascii(kAscii, how);
  EXPECT_EQ(raster.at(2, 0), 101.5F);
  EXPECT_TRUE(std::isnan(raster.at(1, 1)));
}

TEST(ReadRaster, SpacingIsOnTheGround) {
  // 0.5 degrees of longitude at 50.5 degrees north are 35,460 m, of latitude 55,620 m
  EXPECT_NEAR(read_ascii(kAscii).spacing_m.x, 35460, 100);
  EXPECT_NEAR(read_ascii(kAscii).spacing_m.y, 55620, 100);
}

TEST(ReadRaster, WindowFarAwayNeedsNoSamples) {
  const LonLatBox far{100, -20, 101, -19};
  const Raster raster = read_ascii(kAscii, {}, &far);
  EXPECT_EQ(raster.columns, 0);
  EXPECT_TRUE(raster.heights_m.empty());
}

// 30 by 200 samples of level land with one spike near the northern end; between 80 and 84 degrees north the spacing to
// the east shrinks from 390 to 230 m.
std::string arctic_land(int spike_m) {
  std::string text = "ncols 30\nnrows 200\nxllcorner 10\nyllcorner 80\ncellsize 0.02\n";
  for (int row = 0; row < 200; ++row)
    for (int column = 0; column < 30; ++column)
      text += fmt::format("{}{}", row == 8 && column == 15 ? spike_m : 0, column < 29 ? ' ' : '\n');
  return text;
}

TEST(ReadRaster, WindowsOfAFileAreMendedAsTheWhole) {
  const LonLatBox north{10.2, 83.8, 10.4, 83.9};
  for (const int spike_m : {150, 180}) {
    const std::string text = arctic_land(spike_m);
    const Raster whole = read_ascii(text), window = read_ascii(text, {}, &north);
    EXPECT_EQ(whole.file_spacing_m, whole.spacing_m.x);
    EXPECT_EQ(window.file_spacing_m, whole.file_spacing_m);
    EXPECT_LT(window.spacing_m.x, 0.85 * whole.spacing_m.x);
    Report of_whole, of_window;
    spikes_to_voids(whole, of_whole), spikes_to_voids(window, of_window);
    // the threshold is 167 m at the middle of the file and 136 m at the middle of the window
    EXPECT_EQ(of_whole.diagnoses().size(), spike_m == 180 ? 1u : 0u);
    EXPECT_EQ(of_window.diagnoses().size(), of_whole.diagnoses().size());
  }
}

TEST(ReadRaster, TheSpacingOfAThinnedFileIsThatOfItsSamples) {
  const ScratchFolder folder;
  const RasterSpec spec{.path = folder.write("a.asc", arctic_land(0))};
  const Result<Raster> all = read_raster(spec, nullptr), third = read_raster(spec, nullptr, 7000);
  ASSERT_TRUE(all && third);
  ASSERT_EQ(third->columns, 10);
  EXPECT_EQ(third->file_spacing_m, 3 * all->file_spacing_m);
}

TEST(ReadRaster, FileWithoutReferenceSystemMustBeInDegrees) {
  EXPECT_EQ(raster_error_of("a.asc", "ncols 2\nnrows 1\nxllcorner 500000\nyllcorner 4000000\ncellsize 30\n1 2\n"),
            ": the file has no reference system and its coordinates are not degrees");
}

TEST(ReadRasterErrors, MissingEmptyAndForeignFiles) {
  RasterSpec spec;
  spec.path = "/nowhere/N42E001.hgt";
  EXPECT_EQ(to_string(read_raster(spec, nullptr).error()), "/nowhere/N42E001.hgt: no such file");
  EXPECT_EQ(raster_error_of("a.tif", ""), ": the file is empty");
  EXPECT_EQ(raster_error_of("a.tif", "no picture"),
            ": not a readable heightmap: expected .hgt, GeoTIFF, an ASCII grid or PNG");
  EXPECT_EQ(raster_error_of("a.zip", "no archive"), ": no heightmap in the archive; expected .hgt, .tif, .asc or .png");
  EXPECT_EQ(
      raster_error_of("N42E001.hgt", "short"),
      ": not an SRTM heightmap: expected 1201 or 3601 samples a side (2,884,802 or 25,934,402 bytes) and a name like "
      "N42E001.hgt");
}

TEST(ReadRasterErrors, GridCutShort) {
  EXPECT_NE(raster_error_of("a.asc", kAscii.substr(0, kAscii.size() - 6)), "no error");
}

}  // namespace
}  // namespace citykiln::source
