// A viewpoint, and the tolerance that it allows at a place: fine nearby, coarse far away, so that no error in the
// picture is longer than a given number of pixels.
//
//     eye ·------- distance ------->| error      pixels = error / distance · focal length
//
// Objects may be coarser if the picture shows neither them nor their shadow (Sight). A level is a number n that stands
// for the tolerance 2^n · View::finest_m.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "compiler/bake/bounds.h"
#include "compiler/contract/tolerance.h"

namespace citykiln::bake {

/// The region that one picture shows, as a pyramid, and the region whose shadows may fall there. Objects outside both
/// can only affect scattered light and reflections, so they may be coarser.
struct Sight {
  struct Plane {
    Vec3 normal;  ///< Unit length, pointing out of the pyramid.
    double offset_m = 0;
  };
  std::array<Plane, 4> sides;      ///< Sides of the pyramid that the picture shows.
  Vec3 to_sun{};                   ///< Unit length; zero: there are no sharp shadows.
  double lowest_m = 0;             ///< Lowest height that receives shadows.
  double longest_shadow_m = 3000;  ///< Largest length of a shadow, along the light.
  double unseen_rad = 0;           ///< Allowed error of objects that are not seen: an angle from the eye, >= 0.
};

/// True if the bounds or their shadow may be in the picture.
bool is_seen(const Sight& sight, const Bounds& bounds);

/// One or several viewpoints, and the error that is allowed there in all directions.
struct View {
  Vec3 eye;                              ///< Plane metres.
  double focal_px = 0;                   ///< Focal length in pixels (focal_length_px). > 0.
  double pixel_error = 1;                ///< The largest allowed error in the picture, in pixels. > 0.
  double finest_m = kFinestTolerance_m;  ///< The smallest tolerance, for objects near the eye. > 0.
  std::vector<Bounds> more_eyes{};  ///< Boxes that contain further eyes. Distances count from the nearest eye, which
                                    ///< may be anywhere in its box.
  std::optional<Sight> sight{};     ///< For a single picture: objects that it does not show may be coarser.
};

/// The distance from the nearest eye to the bounds; 0 if an eye may be inside.
double distance_m(const View& view, const Bounds& bounds);

/// The focal length of a picture in pixels: the length in the middle of the picture of an object whose length equals
/// its distance. Rounded to 2^-10 pixels.
double focal_length_px(int height_px, double vertical_fov_deg);

/// The level of a place that no tile covers.
inline constexpr int kNoLevel = std::numeric_limits<int>::max();

/// The tolerance of a level: 2^level · View::finest_m; infinite for kNoLevel.
double tolerance_m_of(const View& view, int level);

/// The coarsest level whose error, at the nearest point of the bounds, is at most View::pixel_error. For bounds that
/// View::sight does not show, an error of Sight::unseen_rad is allowed, if that is larger. 0 if no level is fine
/// enough.
int level_for(const View& view, const Bounds& bounds);

/// An upper bound of the length of an error in the picture, in pixels. 0 for bounds so near that they are baked at the
/// finest tolerance in any case.
/// @param bounds  Bounds of the object that has the error.
double pixels_of(const View& view, double error_m, const Bounds& bounds);

}  // namespace citykiln::bake
