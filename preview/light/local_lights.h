// Lights in the scene, street lamps and shining triangles, of which one is sampled for a place.
#pragma once

#include <span>
#include <vector>

#include "preview/light/light_tree.h"
#include "preview/light/rgb.h"
#include "preview/samples.h"
#include "preview/scene/emitters.h"
#include "preview/scene/lamps.h"

namespace citykiln::preview {

/// Light that may reach a place from a sampled point.
struct LightSample {
  Vec3 direction;         ///< Unit, towards the light.
  double distance_m = 0;  ///< That must be free.
  Rgb light{};            ///< Radiance over the density per steradian: times cosine and reflection it is an estimate.
  double pdf = 0;         ///< Per steradian; 0: no ray hits the light by chance, so that this sample is all of it.
};

/// Immutable and thread-safe.
class LocalLights {
 public:
  /// @param emitters  Must outlive this object. @param world_origin  Of the emitters' frame, plane metres.
  LocalLights(std::span<const Emitter> emitters, std::span<const StreetLamp> lamps, Vec3 world_origin);

  bool is_empty() const { return tree_.is_empty(); }
  /// Samples a light for a place, and a point on it. Empty: nothing lights the place, or the point does not.
  /// @param normal  As for LightTree::choose().
  std::optional<LightSample> sample(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  /// The density, per steradian, with which sample() finds this emitter in a direction.
  double pdf(std::uint32_t emitter, Vec3 at, Vec3 normal, Vec3 direction, double distance_m) const;
  const Rgb& radiance_of(std::uint32_t emitter) const { return emitters_[emitter].radiance; }

 private:
  // A lamp as a point of light. Its housing, within radius_m of it, throws no shadow.
  struct Lamp {
    Vec3 at;
    double radius_m;
    Rgb intensity;  // along its axis: radiance times square metres
    bool shines_down;
  };

  std::optional<LightSample> sample_lamp(const Lamp& lamp, Vec3 at) const;
  std::optional<LightSample> sample_emitter(const Emitter& emitter, Vec3 at, UnitPair point) const;

  std::span<const Emitter> emitters_;
  std::vector<Lamp> lamps_;
  LightTree tree_;  // emitters, then lamps
};

}  // namespace citykiln::preview
