// A heightmap: samples on a regular grid in the file's own reference system.
#pragma once

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/source/osm_data.h"

namespace citykiln::source {

/// The value of --dem: FILE[,bounds=W/S/E/N,scale=,offset=,unit=,encoding=,tile=Z/X/Y,credit=].
struct RasterSpec {
  std::string path;
  std::optional<LonLatBox> bounds;  ///< The outer edges of the pixels, for pictures without a georeference.
  double scale = 1;                 ///< height_m = scale * value + offset.
  double offset_m = 0;
  bool is_fitted = false;                      ///< offset=auto: shifted to fit the heightmaps beside or under it.
  std::optional<double> unit_m;                ///< The unit of heights, instead of the one that the file declares.
  std::string encoding;                        ///< "", "terrarium" or "mapbox".
  std::optional<std::array<int, 3>> tile_zxy;  ///< The Web Mercator tile (z, x, y) of a terrarium or mapbox picture.
  std::string credit;                          ///< Added to the attribution of all outputs.
};

/// The value of a sample without a height.
inline constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

/// Heights in metres at the nodes of a grid. Row 0 is the northernmost. Voids are NaN (kVoid).
struct Raster {
  std::string file_name;
  std::string credit;
  int columns = 0, rows = 0;
  std::vector<float> heights_m;  ///< Row by row, columns * rows.
  /// The centre of sample (c, r) is at (a0 + a1 c + a2 r, a3 + a4 c + a5 r) in the raster's own system. GDAL's
  /// geotransform refers to the pixel's corner instead.
  std::array<double, 6> from_grid{};
  std::string system_wkt;  ///< The raster's own system; empty: longitude and latitude on WGS84 in degrees.
  Vec2 spacing_m;        ///< Distances between samples east and north, at the centre (spacing_m_of); 0 without samples.
  LonLatBox file_box{};  ///< The box of all samples in the file, in degrees; zeros if its system cannot be converted.
  /// The shorter distance between samples at the centre of the whole file, times the stride of a thinned raster; of
  /// joined rasters the smallest. Mending uses it, so that samples are mended alike in each window of a file.
  double file_spacing_m = 0;
  double unit_m = 1;       ///< The unit of heights that the file declares; the heights are converted from it.
  bool is_fitted = false;  ///< RasterSpec::is_fitted.
  double shift_m = 0;      ///< Metres added to fit other heightmaps (map/heights/fit_heightmaps.h).
  /// The heights that stand for 0 and for the ends of the file's number type: values that programs write where they
  /// know no height.
  std::vector<float> code_heights_m;

  bool has_all_samples() const { return heights_m.size() == static_cast<std::size_t>(columns) * rows; }
  float at(int column, int row) const {
    assert(column >= 0 && column < columns && row >= 0 && row < rows);
    return heights_m[static_cast<std::size_t>(row) * columns + column];
  }
};

}  // namespace citykiln::source
