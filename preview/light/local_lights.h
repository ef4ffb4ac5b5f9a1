// Lights in the scene: street lamps and shining triangles. For a place one of them is sampled.
#pragma once

#include <span>
#include <vector>

#include "preview/light/light_tree.h"
#include "preview/light/pane_lights.h"
#include "preview/rgb.h"
#include "preview/samples.h"
#include "preview/scene/emitters.h"
#include "preview/scene/lamps.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// Light that may reach a place from a sampled point.
struct LightSample {
  Vec3 direction;         ///< Unit, towards the light.
  double distance_m = 0;  ///< Distance along which nothing may block the light.
  /// Radiance over pdf, or a lamp's intensity over distance². Times cosine and BSDF it estimates the light.
  Rgb light{};
  double pdf = 0;  ///< Density per steradian; 0: no ray hits the light by chance, so this sample is all of it.
};

/// The street lamps, shining triangles and lit windows of a world. Immutable and thread-safe.
class LocalLights {
 public:
  /// Makes the lights of a world, which must outlive this object. Emitters that light only their neighbourhood (within
  /// 4 m), such as the walls of rooms, are not sampled: only rays that hit them by chance see them. Cost: 16 rays for
  /// each emitter.
  /// @param panes  Lit windows of a world of cells, whose emitters are not known.
  LocalLights(const World& world, std::span<const StreetLamp> lamps, int threads, std::span<const LitPane> panes = {});

  bool has_lamps() const { return !lamp_tree_.is_empty(); }
  bool has_emitters() const { return !emitter_tree_.is_empty(); }
  const PaneLights& panes() const { return panes_; }
  /// Samples a lamp for a place. No ray hits a lamp by chance, so its pdf is 0. Empty: no lamp lights the place.
  /// @param normal  See LightTree::choose().
  std::optional<LightSample> sample_lamp(Vec3 at, Vec3 normal, double chance) const;
  /// Samples an emitter for a place, and a point on it. Empty: no emitter lights the place, or the point is on the
  /// back.
  std::optional<LightSample> sample_emitter(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  bool is_sampled(std::uint32_t emitter) const { return is_sampled_[emitter] != 0; }
  /// The density, per steradian, with which sample_emitter() gives this emitter and direction; 0 for an emitter that is
  /// not sampled.
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

  std::optional<LightSample> light_of(const Lamp& lamp, Vec3 at) const;
  std::optional<LightSample> light_of(const Emitter& emitter, Vec3 at, UnitPair point) const;

  std::span<const Emitter> emitters_;
  std::vector<char> is_sampled_;
  std::vector<Lamp> lamps_;
  LightTree emitter_tree_, lamp_tree_;
  PaneLights panes_;
};

}  // namespace citykiln::preview
