// Lit windows of buildings that are not generated yet: a point on a pane is sampled, and what the ray through it meets
// shines or does not.
//
//     place ·-------- ray --------> | pane, known from recipes
//                                  o|  what the ray meets in the building, at whatever tolerance
//
// A direction belongs to at most one pane, a function of the ray and of its hit. A sample counts only if its direction
// belongs to the pane that was chosen, so each direction has one density, and what panes miss, such as windows in
// roofs, is still found by chance.
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
  std::uint32_t pane = 0;  ///< To which it must belong.
  double pdf = 0;          ///< Per steradian. > 0.
};

inline constexpr std::uint32_t kNoPane = std::numeric_limits<std::uint32_t>::max();

/// Immutable and thread-safe. Memory: some 250 bytes a pane.
class PaneLights {
 public:
  PaneLights() = default;
  /// @param origin  Of the world, plane metres.
  PaneLights(std::span<const LitPane> panes, Vec3 origin);

  bool is_empty() const { return tree_.is_empty(); }
  /// Samples a direction from a place. Empty: no pane is turned towards it.
  /// @param normal  As for LightTree::choose().
  std::optional<PaneSample> sample(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  /// The pane that a direction from a place belongs to, or kNoPane: of the hit's building the one whose crossing is
  /// nearest to the hit. O(panes of the building).
  std::uint32_t pane_of(const Hit& hit, Vec3 at, Vec3 direction) const;
  /// The density, per steradian, with which sample() gives a direction that belongs to the pane; 0 for kNoPane.
  double pdf(std::uint32_t pane, Vec3 at, Vec3 normal, Vec3 direction) const;

 private:
  // In the world's frame.
  struct Pane {
    OsmId building;
    Vec3 corner, along, outward;
    double width_m, height_m;
    /// The distance at which a ray crosses it from outside; negative where it does not.
    double crossing_m(Vec3 at, Vec3 direction) const;
  };

  std::vector<Pane> panes_;  // sorted by building
  LightTree tree_{{}};
};

}  // namespace citykiln::preview
