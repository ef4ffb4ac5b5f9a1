// Samples lit windows of buildings whose meshes are not generated yet. A pane is the rectangle of a lit window, known
// from the recipe of the building: plain data that states its shape and rules but holds no triangles. A direction to a
// point on a pane is sampled; the ray in this direction then finds the surface that it hits, which shines or does not.
//
//     place ·-------- ray --------> | pane, known from recipes
//                                  o|  the ray's hit on the building, generated at any tolerance
//
// Each direction belongs to at most one pane; pane_of() finds it from the ray and its hit alone. A sample counts only
// if its direction belongs to the chosen pane, so each direction has one density. Lit windows without a pane, such as
// windows in roofs, light a place only by rays that happen to hit them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "preview/light/light_tree.h"
#include "preview/samples.h"
#include "preview/scene/hit.h"
#include "preview/scene/lit_panes.h"

namespace citykiln::preview {

/// A direction towards a pane.
struct PaneSample {
  Vec3 direction;          ///< Unit.
  std::uint32_t pane = 0;  ///< The pane that the direction must belong to for the sample to count.
  double pdf = 0;          ///< Density per steradian. > 0.
};

/// The index of a pane where there is none.
inline constexpr std::uint32_t kNoPane = std::numeric_limits<std::uint32_t>::max();

/// The lit panes of buildings, from which directions are sampled. Immutable and thread-safe. Memory: some 360 bytes a
/// pane.
class PaneLights {
 public:
  PaneLights() = default;
  /// @param origin  The world's origin in metres on the map plane, z up.
  PaneLights(std::span<const LitPane> panes, Vec3 origin);

  bool is_empty() const { return tree_.is_empty(); }
  /// Samples a direction from a place to a pane. Empty: no pane faces the place.
  /// @param at      The place that receives light, in the frame of the world.
  /// @param normal  Unit normal of a surface at the place, which receives light only from its front. Zero: from all
  /// directions.
  /// @param chance  A uniform random number in [0, 1), for the pane.
  /// @param point   Two uniform random numbers in [0, 1), for the point on the pane.
  std::optional<PaneSample> sample(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  /// Returns the index of the pane that a direction from a place belongs to: among the panes of the building that was
  /// hit, the pane that the ray crosses nearest to the hit, within 1.5 m. kNoPane if there is none. O(panes of the
  /// building).
  std::uint32_t pane_of(const Hit& hit, Vec3 at, Vec3 direction) const;
  /// Returns the density, per steradian, with which sample() gives this pane and direction from a place; 0 for kNoPane.
  /// Places and directions are in the frame of the world.
  double pdf(std::uint32_t pane, Vec3 at, Vec3 normal, Vec3 direction) const;

 private:
  // A pane in the world's frame.
  struct Pane {
    OsmId building;
    Vec3 corner, along, outward;
    double width_m, height_m;
    /// The distance at which a ray crosses the pane from outside; negative if it does not.
    double crossing_m(Vec3 at, Vec3 direction) const;
  };

  std::vector<Pane> panes_;  // sorted by building
  LightTree tree_{{}};
};

}  // namespace citykiln::preview
