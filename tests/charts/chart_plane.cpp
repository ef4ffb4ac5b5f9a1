// Distortion and speed of map planes: straight lines of the plane against geodesics (Karney 2013, GeographicLib).
#include <fmt/format.h>

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compiler/map/plane/plane.h"
#include "tests/charts/chart.h"
#include "tests/charts/stopwatch.h"

namespace citykiln::charts {
namespace {

/// Short enough for a line to be straight, long enough for rounding not to matter.
constexpr double kStep_m = 10;
constexpr double kDegree_rad = std::numbers::pi / 180;
/// Equatorial radius of WGS84.
constexpr double kRadius_m = 6378137;

using Project = std::function<Vec2(LonLat)>;

struct Projection {
  std::string name;
  Project project;
};

/// Spherical Mercator as in web maps, scaled to true size at the origin (first order).
Vec2 web_mercator(LonLat place, double scale) {
  const double y = std::log(std::tan(std::numbers::pi / 4 + place.lat_deg * kDegree_rad / 2));
  return {kRadius_m * place.lon_deg * kDegree_rad * scale, kRadius_m * y * scale};
}

Vec2 equirectangular(LonLat place, LonLat origin) {
  const double x = (place.lon_deg - origin.lon_deg) * std::cos(origin.lat_deg * kDegree_rad);
  return Vec2{x, place.lat_deg - origin.lat_deg} * (kDegree_rad * kRadius_m);
}

std::vector<Projection> projections_of(const map::Plane& plane) {
  const LonLat origin = plane.origin();
  const double scale = std::cos(origin.lat_deg * kDegree_rad);
  return {{"citykiln's plane (transverse Mercator)", [&plane](LonLat p) { return plane.forward(p); }},
          {"Web Mercator, scaled at the origin", [scale](LonLat p) { return web_mercator(p, scale); }},
          {"equirectangular", [origin](LonLat p) { return equirectangular(p, origin); }}};
}

LonLat walked(LonLat from, double azimuth_deg, double distance_m) {
  LonLat to;
  GeographicLib::Geodesic::WGS84().Direct(from.lat_deg, from.lon_deg, azimuth_deg, distance_m, to.lat_deg, to.lon_deg);
  return to;
}

/// The largest relative error of lengths, and of right angles in degrees, over all directions.
struct Distortion {
  double length = 0, angle_deg = 0;
};

Distortion distortion_at(LonLat place, const Project& project) {
  Distortion worst;
  const Vec2 here = project(place);
  for (int azimuth_deg = 0; azimuth_deg < 180; azimuth_deg += 15) {
    const Vec2 along = project(walked(place, azimuth_deg, kStep_m)) - here;
    const Vec2 across = project(walked(place, azimuth_deg + 90, kStep_m)) - here;
    const double angle_deg = std::atan2(std::abs(cross(along, across)), dot(along, across)) / kDegree_rad;
    worst.length = std::max(worst.length, std::abs(length(along) / kStep_m - 1));
    worst.angle_deg = std::max(worst.angle_deg, std::abs(angle_deg - 90));
  }
  return worst;
}

Distortion distortion_at_distance(LonLat origin, double distance_m, const Project& project) {
  Distortion worst;
  for (int azimuth_deg = 0; azimuth_deg < 360; azimuth_deg += 45) {
    const Distortion here = distortion_at(walked(origin, azimuth_deg, distance_m), project);
    worst.length = std::max(worst.length, here.length);
    worst.angle_deg = std::max(worst.angle_deg, here.angle_deg);
  }
  return worst;
}

/// Microseconds per point, over a grid about the origin.
double time_us(LonLat origin, const Project& project) {
  constexpr int kPoints = 200'000;
  double sum = 0;
  const Stopwatch watch;
  for (int i = 0; i < kPoints; ++i) {
    const Vec2 p = project({origin.lon_deg + (i % 447) * 1e-3, origin.lat_deg + (i / 447) * 1e-3});
    sum += p.x + p.y;
  }
  const double microseconds = watch.microseconds();
  // uses the sum, so that the loop is not optimised away
  return std::isfinite(sum) ? microseconds / kPoints : 0;
}

}  // namespace

Result<std::vector<Chart>> chart_plane(const ChartRequest& request) {
  const map::Plane plane({1.5, request.lat_deg});
  const Axis distance{"distance from the origin (km)", true};
  const std::string where = fmt::format("origin at {}° north", request.lat_deg);
  Chart lengths{"plane_length",
                "Error of lengths against the geodesic, " + where,
                distance,
                {"worst error of a length (ppm)", true},
                {}};
  Chart angles{"plane_angle",
               "Error of angles against the geodesic, " + where,
               distance,
               {"worst error of a right angle (°)", true},
               {}};

  for (const Projection& projection : projections_of(plane)) {
    const std::string name =
        fmt::format("{}: {:.2f} µs a point", projection.name, time_us(plane.origin(), projection.project));
    lengths.series.push_back({name, {}});
    angles.series.push_back({name, {}});
    for (const double distance_km : {1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 18.0, 25.0, 35.0, 50.0, 70.0, 100.0}) {
      const Distortion worst = distortion_at_distance(plane.origin(), distance_km * 1000, projection.project);
      lengths.series.back().points.emplace_back(distance_km, worst.length * 1e6);
      angles.series.back().points.emplace_back(distance_km, worst.angle_deg);
    }
  }
  return std::vector{lengths, angles};
}

}  // namespace citykiln::charts
