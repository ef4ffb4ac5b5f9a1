#include "compiler/map/plane/geoid.h"

#include <fmt/format.h>

#include <GeographicLib/Geoid.hpp>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "compiler/contract/texts/parse.h"
#include "compiler/geometry/snap.h"

namespace citykiln::map {
namespace {

/// The cell of a grid line that a coordinate is in, and its share of the way to the next point.
struct AlongGrid {
  std::size_t cell, next;
  double share;
};

AlongGrid along(double offset_m, double step_m, std::size_t points) {
  const double last = static_cast<double>(points - 1);
  const double at = std::clamp(offset_m / step_m, 0.0, last);
  const double cell = std::min(std::floor(at), std::max(0.0, last - 1));
  const auto index = static_cast<std::size_t>(cell);
  return {index, std::min(index + 1, points - 1), at - cell};
}

Geoid sampled(const GeographicLib::Geoid& source, const Box2& box, const Plane& plane) {
  const auto steps = [](double m) { return static_cast<std::size_t>(std::ceil(m / kGeoidStep_m)) + 1; };
  const Box2 wide = box.widened(kGeoidStep_m);
  Geoid geoid{wide.min, kGeoidStep_m, steps(wide.width()), {}};
  for (std::size_t row = 0; row < steps(wide.height()); ++row)
    for (std::size_t column = 0; column < geoid.columns; ++column) {
      const Vec2 p = wide.min + Vec2{static_cast<double>(column), static_cast<double>(row)} * kGeoidStep_m;
      const LonLat place = plane.backward(p);
      geoid.heights_m.push_back(snapped(source(place.lat_deg, place.lon_deg)));
    }
  return geoid;
}

// GeographicLib takes a folder and a name without .pgm.
Result<Geoid> read_grid(const std::string& path, const Box2& box, const Plane& plane) {
  const std::size_t slash = path.rfind('/'), name = slash == std::string::npos ? 0 : slash + 1;
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, std::max<std::size_t>(1, slash));
  try {
    return sampled(GeographicLib::Geoid(path.substr(name, path.size() - name - 4), folder), box, plane);
  } catch (const std::exception& thrown) {
    const std::string what = thrown.what();
    return Error{path, "expected a geoid of GeographicLib, such as egm96-5.pgm: " + what.substr(0, what.find('\n'))};
  }
}

}  // namespace

double height_m(const Geoid& geoid, Vec2 p) {
  assert(geoid.columns > 0 && geoid.heights_m.size() % geoid.columns == 0 && !geoid.heights_m.empty());
  const AlongGrid x = along(p.x - geoid.low.x, geoid.step_m, geoid.columns),
                  y = along(p.y - geoid.low.y, geoid.step_m, geoid.heights_m.size() / geoid.columns);
  const auto in_row = [&](std::size_t row) {
    const double* heights_m = &geoid.heights_m[row * geoid.columns];
    return heights_m[x.cell] * (1 - x.share) + heights_m[x.next] * x.share;
  };
  return in_row(y.cell) * (1 - y.share) + in_row(y.next) * y.share;
}

Result<GeoidSource> parse_geoid(std::string_view text) {
  const std::optional<double> level_m = number_in<double>(text);
  if (level_m || text.ends_with(".pgm")) return GeoidSource{std::string(text), level_m};
  return Error{"", fmt::format("expected a height in metres, such as 47.3, or a geoid of GeographicLib, such as "
                               "egm96-5.pgm, found \"{}\"",
                               text)};
}

Result<Geoid> read_geoid(const std::optional<GeoidSource>& source, const Box2& box, const Plane& plane) {
  if (!source) return Geoid{};
  if (source->level_m) return Geoid{.low = {}, .heights_m = {snapped(*source->level_m)}};
  return read_grid(source->name, box, plane);
}

}  // namespace citykiln::map
