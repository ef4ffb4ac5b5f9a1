// Light, air and walls inside of a cylinder, which replace sky, sun and the land around.
#pragma once

#include <optional>
#include <vector>

#include "compiler/sky/atmosphere/sky_dome.h"
#include "compiler/sky/inside/line_light.h"
#include "compiler/sky/inside/recipe.h"
#include "compiler/sky/recipe.h"
#include "preview/light/light_sample.h"
#include "preview/rgb.h"
#include "preview/samples.h"

namespace citykiln::preview {

/// A surface that a ray meets.
struct Seen {
  double distance_m = 0;
  Rgb radiance{};
};

/// Lines of light along the axis, the air between them, and the bare hull where there is no map. Places are in the
/// frame of map/plane/cylinder.h, radiances in sky::kUnitLuminance_cd_m2. Immutable and thread-safe.
class InsideLights {
 public:
  /// @param sky  Its `inside` is set. By night the lines are dark.
  explicit InsideLights(const sky::Sky& sky);

  bool are_lit() const { return are_lit_; }
  const map::Cylinder& cylinder() const { return inside_.cylinder; }
  /// Samples a point of a line for a place: a line in proportion to its unblocked irradiance, then the sine of the
  /// angle along it evenly, by which the weight of a matt surface varies with its own cosine only. Air on the way is
  /// in LightSample::light; pdf is 0. Empty: no line lights the place.
  /// @param normal  Unit normal; zero: light comes from all sides.
  std::optional<LightSample> sample(Vec3 at, Vec3 normal, UnitPair chance) const;
  /// Returns the tube of a line that a ray meets first, without the air before it; empty by night.
  std::optional<Seen> tube(Vec3 from, Vec3 direction) const;
  /// Returns the bare hull that a ray meets, lit by the lines without shadows, without the air before it.
  Seen hull(Vec3 from, Vec3 direction) const;
  /// Returns the share of light that passes the air along a ray, and the light of the lines that the air adds by
  /// scattering it once, evenly in all directions.
  ///
  /// Near a line its light grows as one over the distance. Each line's part is integrated over the inverse hyperbolic
  /// sine of the way along the ray, by which that growth cancels: eight points by Gauss on either side of the point
  /// nearest to the line.
  sky::AirPath air(Vec3 from, Vec3 direction, double distance_m) const;

 private:
  // A line with its ends in the frame of the cylinder.
  struct Line {
    Vec3 from, to;
    double radius_m;
    Rgb intensity;  // across the line, of a metre
    Rgb radiance;   // of the tube
  };

  Rgb passed(double column_m) const;
  Rgb irradiance_at(Vec3 place, Vec3 normal) const;
  Rgb added_by(const Line& line, Vec3 from, Vec3 direction, double distance_m) const;
  Rgb scattered_at(const Line& line, Vec3 from, Vec3 direction, double distance_m) const;

  sky::Inside inside_;
  bool are_lit_;
  Rgb extinction_per_m_;
  std::vector<Line> lines_;
};

}  // namespace citykiln::preview
