// The sky recipe: directions of sun, moon and stars, and the state of the air.
#pragma once

#include <optional>
#include <vector>

#include "compiler/geometry/vec.h"
#include "compiler/sky/clouds/recipe.h"
#include "compiler/sky/inside/recipe.h"
#include "compiler/sky/moment.h"

namespace citykiln::sky {

/// The sky of a scene. Directions are unit vectors (x east, y north, z up) whose components are multiples of 2^-20. The
/// directions of sun and moon are apparent: lifted by refraction.
struct Sky {
  std::optional<Moment> time;  ///< plan() sets it.
  Vec3 to_sun{0, 0, 1};        ///< The middle of the disk.
  double turbidity = 2.6;      ///< Haze of the whole column of air: 2 clear, 10 hazy.
  double visibility_km = 100;  ///< Distance at which a black object at sea level keeps 2 % of its contrast, at 550 nm.
  double ground_albedo = 0.2;  ///< Share of light that the ground reflects back into the air.
  Vec3 to_moon{0, 0, -1};      ///< Seen from the place, not from the Earth's centre.
  double moon_lit = 0;         ///< Lit share of the moon's disk: 0 new, 1 full; a multiple of 2^-20.
  Vec3 to_pole{0, 0, 1};       ///< Direction of declination 90° of J2000.0, without refraction.
  Vec3 to_equinox{0, -1, 0};   ///< Direction of right ascension 0, declination 0 of J2000.0, without refraction.
  double ground_m = 0;         ///< Mean height of the ground above sea level. Heights of named clouds are above it.
  std::vector<CloudLayer> clouds{};
  std::optional<Inside> inside{};  ///< Set if the world is the inside of a cylinder.
  /// True: the user gave no clouds. Pictures show those of `clouds`, outputs have no files of them.
  bool clouds_are_default = false;
  bool operator==(const Sky&) const = default;
};

/// True if outputs contain the clouds: there are some, and they were asked for.
inline bool has_cloud_files(const Sky& sky) { return !sky.clouds.empty() && !sky.clouds_are_default; }

/// True if the sun has set: its upper limb, with refraction, is below the horizon.
inline bool is_night(const Sky& sky) { return sky.to_sun.z < -0.00466; }

/// True if street lamps are lit: the sun is 4° below the horizon, when a clear sky gives the 35 lx at which photocells
/// of street lighting switch (BS 5972).
inline bool are_lamps_lit(const Sky& sky) { return sky.to_sun.z < -0.06976; }

/// True if the lines inside of a cylinder shine: while street lamps are not lit. False for other worlds.
inline bool are_lines_lit(const Sky& sky) { return sky.inside && !are_lamps_lit(sky); }

}  // namespace citykiln::sky
