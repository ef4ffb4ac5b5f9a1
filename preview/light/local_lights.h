// Lights in the scene: street lamps, emitters (triangles that shine) and lit windows. For a place, one light and a
// point on it are sampled.
#pragma once

#include <span>
#include <vector>

#include "preview/light/light_sample.h"
#include "preview/light/light_tree.h"
#include "preview/light/pane_lights.h"
#include "preview/rgb.h"
#include "preview/samples.h"
#include "preview/scene/emitters.h"
#include "preview/scene/lamps.h"
#include "preview/scene/world.h"

namespace citykiln::preview {

/// The street lamps, shining triangles and lit windows of a world. Immutable and thread-safe.
class LocalLights {
 public:
  /// Collects the lights of a world, which must outlive this object. Emitters that light only their neighbourhood
  /// (within 4 m), such as the walls of rooms, are not sampled: they light a place only by rays that happen to hit
  /// them. Cost: 16 rays for each emitter.
  /// @param lamps  Street lamps that are lit, plane metres.
  /// @param panes  Lit windows, for a world that generates its meshes on demand and has no list of emitters.
  LocalLights(const World& world, std::span<const StreetLamp> lamps, int threads, std::span<const LitPane> panes = {});

  bool has_lamps() const { return !lamp_tree_.is_empty(); }
  bool has_emitters() const { return !emitter_tree_.is_empty(); }
  /// Returns the lit windows, which are sampled by PaneLights::sample().
  const PaneLights& pane_lights() const { return panes_; }
  /// Samples a lamp for a place, with LightSample::pdf 0. Empty: the lamp that was drawn does not light the place, or
  /// none does.
  /// @param at      The place that receives light, in the frame of the world.
  /// @param normal  Unit normal of a surface at the place, which receives light only from its front. Zero: from all
  /// directions.
  /// @param chance  A uniform random number in [0, 1).
  std::optional<LightSample> sample_lamp(Vec3 at, Vec3 normal, double chance) const;
  /// Samples an emitter for a place, and a point on the emitter. Empty: no emitter lights the place, or the place is
  /// behind the one that was drawn.
  /// @param point  Two uniform random numbers in [0, 1), for the point on the emitter.
  std::optional<LightSample> sample_emitter(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  /// True if sample_emitter() can give this emitter.
  /// @param emitter  An index into World::emitters().
  bool is_sampled(std::uint32_t emitter) const { return is_sampled_[emitter] != 0; }
  /// Returns the density, per steradian, with which sample_emitter() gives this emitter and direction; 0 for an emitter
  /// that is not sampled.
  /// @param distance_m  The distance from the place to the emitter in this direction.
  double pdf(std::uint32_t emitter, Vec3 at, Vec3 normal, Vec3 direction, double distance_m) const;
  /// Returns the radiance of an emitter.
  const Rgb& radiance_of(std::uint32_t emitter) const { return emitters_[emitter].radiance; }

 private:
  // A lamp as a point of light. Its housing, within radius_m of it, throws no shadow.
  struct Lamp {
    Vec3 at;
    double radius_m;
    Rgb intensity;  // along its axis: radiance times square metres
    bool shines_down;
    Vec3 up;
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
