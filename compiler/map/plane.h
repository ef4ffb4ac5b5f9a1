// The map plane: transverse Mercator about the job's origin, x east, y north, metres, scale 1 at the origin.
#pragma once

#include <memory>

#include "compiler/geometry/vec.h"
#include "compiler/source/osm_data.h"

namespace citykiln::map {

/// The grid of map positions. Finer than OSM's own grid of 1e-7 degrees or 11 mm: more digits would store noise.
inline constexpr double kMapStep_m = 0x1p-7;

struct LonLat {
  double lon_deg = 0, lat_deg = 0;
  bool operator==(const LonLat&) const = default;
};

/// The projection of a job. Method: GeographicLib's series (Karney 2011), 0.28 µs a point, error under 5 nm. The scale
/// error at distance x from the origin's meridian is x²/2R², under 8 ppm within 25 km. Total: longitudes more than 80°
/// away are clamped.
class Plane {
 public:
  explicit Plane(LonLat origin);
  ~Plane();
  Plane(Plane&&) noexcept;
  Plane& operator=(Plane&&) noexcept;

  LonLat origin() const;
  Vec2 forward(LonLat place) const;  ///< Not snapped.
  LonLat backward(Vec2 p) const;
  /// Returns forward(), snapped to kMapStep_m. Points within 1e-5 step of a tie are computed again in higher precision,
  /// so that every CPU agrees.
  Vec2 snapped_forward(source::Location place) const;

 private:
  struct Projection;
  std::unique_ptr<Projection> projection_;
};

}  // namespace citykiln::map
