#include "compiler/source/gdal_module/raster_system.h"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "compiler/geometry/snap.h"
#include "compiler/source/gdal_module/quiet_gdal.h"
#include "compiler/source/height_units.h"

namespace citykiln::source::gdal {
namespace {

using Transform = std::unique_ptr<OGRCoordinateTransformation>;

OGRSpatialReference wgs84() {
  OGRSpatialReference system;
  system.SetFromUserInput(SRS_WKT_WGS84_LAT_LONG);
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

OGRSpatialReference system_from(const std::string& wkt) {
  OGRSpatialReference system;
  system.importFromWkt(wkt.c_str());
  system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return system;
}

bool is_wgs84(const OGRSpatialReference& system) {
  constexpr const char* kOptions[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT", nullptr};
  const OGRSpatialReference reference = wgs84();
  return system.IsGeographic() && system.IsSame(&reference, kOptions);
}

std::string wkt_of(const OGRSpatialReference& system) {
  char* text = nullptr;
  constexpr const char* kOptions[] = {"FORMAT=WKT2_2018", nullptr};
  system.exportToWkt(&text, kOptions);
  std::string wkt = text ? text : "";
  CPLFree(text);
  return wkt;
}

struct Place {
  double x = 0, y = 0;
};

Place place_of_sample(const Raster& raster, double column, double row) {
  const std::array<double, 6>& a = raster.from_grid;
  return {a[0] + a[1] * column + a[2] * row, a[3] + a[4] * column + a[5] * row};
}

// The offset between two close places, metres east and north on the WGS84 ellipsoid.
Vec2 offset_m(Place a, Place b) {
  constexpr double kEquator_m = 6378137.0, kEccentricity2 = 6.69437999014e-3, kRadians = M_PI / 180;
  const double latitude = (a.y + b.y) / 2 * kRadians;
  const double w2 = 1 - kEccentricity2 * std::sin(latitude) * std::sin(latitude);
  const double prime_vertical_m = kEquator_m / std::sqrt(w2);
  const double meridian_m = prime_vertical_m * (1 - kEccentricity2) / w2;
  return {(b.x - a.x) * kRadians * prime_vertical_m * std::cos(latitude), (b.y - a.y) * kRadians * meridian_m};
}

// Spacing east and north of a grid with these offsets between columns and between rows.
Vec2 east_and_north_m(Vec2 column, Vec2 row) {
  constexpr double kTurned = 0.125;
  const auto runs_east = [](Vec2 v) { return std::abs(v.y) <= kTurned * std::abs(v.x); };
  const auto runs_north = [](Vec2 v) { return std::abs(v.x) <= kTurned * std::abs(v.y); };
  const double column_m = length(column), row_m = length(row), least_m = std::min(column_m, row_m);
  if (runs_east(column) && runs_north(row)) return {column_m, row_m};
  if (runs_north(column) && runs_east(row)) return {row_m, column_m};
  return {least_m, least_m};
}

// The transformation from the raster's system to longitude and latitude; null if PROJ knows none.
Transform to_wgs84(const std::string& wkt) {
  const OGRSpatialReference from = system_from(wkt), to = wgs84();
  return Transform(OGRCreateCoordinateTransformation(&from, &to));
}

}  // namespace

std::string system_wkt_of(const OGRSpatialReference& system) {
  if (!system.IsCompound()) return is_wgs84(system) ? "" : wkt_of(system);
  OGRSpatialReference horizontal(system);
  horizontal.StripVertical();
  return is_wgs84(horizontal) ? "" : wkt_of(horizontal);
}

std::optional<double> height_unit_m(const OGRSpatialReference* system, const std::string& band_unit) {
  if (const std::optional<double> of_band = unit_of_heights_m(band_unit)) return of_band;
  if (system == nullptr || !system->IsCompound()) return std::nullopt;
  return system->GetTargetLinearUnits("COMPD_CS|VERT_CS");
}

std::string web_mercator_wkt() {
  OGRSpatialReference system;
  system.importFromEPSG(3857);
  return wkt_of(system);
}

Vec2 sample_spacing_m(const Raster& raster) {
  const QuietGdal quiet;
  const double column = (raster.columns - 1) / 2.0, row = (raster.rows - 1) / 2.0;
  std::array<Place, 3> places = {place_of_sample(raster, column, row), place_of_sample(raster, column + 1, row),
                                 place_of_sample(raster, column, row + 1)};
  if (!raster.system_wkt.empty()) {
    const Transform transform = to_wgs84(raster.system_wkt);
    for (Place& place : places) {
      if (!transform || !transform->Transform(1, &place.x, &place.y)) return {};
    }
  }
  return snapped(east_and_north_m(offset_m(places[0], places[1]), offset_m(places[0], places[2])));
}

LonLatBox lonlat_box_of(const Raster& raster) {
  const QuietGdal quiet;
  const Transform transform = raster.system_wkt.empty() ? nullptr : to_wgs84(raster.system_wkt);
  LonLatBox box{180, 90, -180, -90};
  for (const double across : {0.0, 0.5, 1.0})
    for (const double down : {0.0, 0.5, 1.0}) {
      Place place = place_of_sample(raster, (raster.columns - 1) * across, (raster.rows - 1) * down);
      if (!raster.system_wkt.empty() && (!transform || !transform->Transform(1, &place.x, &place.y))) continue;
      box = {std::min(box.west, place.x), std::min(box.south, place.y), std::max(box.east, place.x),
             std::max(box.north, place.y)};
    }
  return box.west <= box.east ? box : LonLatBox{};
}

Result<ToRasterSystem> from_wgs84(const Raster& raster) {
  if (raster.system_wkt.empty()) return ToRasterSystem([](double&, double&) {});
  const QuietGdal quiet;
  const OGRSpatialReference from = wgs84(), to = system_from(raster.system_wkt);
  const std::shared_ptr<OGRCoordinateTransformation> transform(OGRCreateCoordinateTransformation(&from, &to));
  if (!transform)
    return Error{raster.file_name, "its reference system cannot be converted from WGS84: " + quiet.last_message()};
  return ToRasterSystem([transform](double& x, double& y) {
    const QuietGdal quiet_call;
    if (!transform->Transform(1, &x, &y)) x = y = std::numeric_limits<double>::quiet_NaN();
  });
}

}  // namespace citykiln::source::gdal
