// Lit windows of buildings that are not generated yet. A point on a pane is sampled, and the ray towards it finds out
// whether the surface that it hits there shines.
//
//     place ·-------- ray --------> | pane, known from recipes
//                                  o|  the ray's hit on the building, generated at any tolerance
//
// Each direction belongs to at most one pane, which is a function of the ray and its hit. A sample counts only if its
// direction belongs to the pane that was chosen, so each direction has one density. Lit windows without a pane here,
// such as those in roofs, are still hit by chance.
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

inline constexpr std::uint32_t kNoPane = std::numeric_limits<std::uint32_t>::max();

/// The lit panes of buildings, from which directions are sampled. Immutable and thread-safe. Memory: some 250 bytes a
/// pane.
class PaneLights {
 public:
  PaneLights() = default;
  /// @param origin  The world's origin in plane metres.
  PaneLights(std::span<const LitPane> panes, Vec3 origin);

  bool is_empty() const { return tree_.is_empty(); }
  /// Samples a direction from a place to a pane. Empty: no pane is turned towards it.
  /// @param normal  See LightTree::choose().
  std::optional<PaneSample> sample(Vec3 at, Vec3 normal, double chance, UnitPair point) const;
  /// The pane that a direction from a place belongs to: among those of the hit's building, the one that the ray crosses
  /// nearest to the hit, within 1.5 m. kNoPane if there is none. O(panes of the building).
  std::uint32_t pane_of(const Hit& hit, Vec3 at, Vec3 direction) const;
  /// The density, per steradian, with which sample() gives this pane and direction; 0 for kNoPane.
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
