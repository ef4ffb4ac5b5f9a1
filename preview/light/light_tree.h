// A tree over many light sources, from which one is sampled for a place about in proportion to the light that it sends
// there.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/geometry/vec.h"

namespace citykiln::preview {

/// Where a light source, or a group of them, is and in which directions it shines.
struct LightBounds {
  Vec3 low, high;         ///< A box around it.
  Vec3 axis{0, 0, 1};     ///< Unit: the middle of the normals of its surfaces.
  double spread_rad = 0;  ///< Normals are within this angle of the axis.
  double reach_rad = 0;   ///< Light leaves within this angle of a normal; at most a right angle for surfaces.
  double flux = 0;        ///< Of luminance, any unit: that of a surface as bright along its normal. >= 0.
  /// Whether it is as bright in all directions within reach, as a lantern is; else by the cosine, as a surface is.
  bool is_even = false;
};

/// The smallest bounds of both; even if one is.
LightBounds joined(const LightBounds& a, const LightBounds& b);

/// A sampled source.
struct LightChoice {
  std::uint32_t light = 0;
  double probability = 0;
};

/// Method: a binary tree by the surface area and orientation heuristic; the way down is drawn by an estimate of the
/// light that each half may send at most to the place. Every source that may light a place has a probability above 0,
/// so the choice is unbiased. Source: Conty Estevez, Kulla, "Importance Sampling of Many Lights with Adaptive Tree
/// Splitting", PACMCGIT 1(2), 2018.
///
/// Immutable and thread-safe. Memory: some 130 bytes a source. Cost: O(n log n), then O(log n) per choice.
class LightTree {
 public:
  /// Sources without flux are never chosen.
  explicit LightTree(std::span<const LightBounds> lights);

  bool is_empty() const { return nodes_.empty(); }
  /// Samples a source for a place. Empty: no source lights it.
  /// @param normal  Of a surface that receives light from above it alone; zero: from everywhere.
  /// @param chance  In [0, 1).
  std::optional<LightChoice> choose(Vec3 at, Vec3 normal, double chance) const;
  /// The probability with which choose() gives this source.
  double probability(std::uint32_t light, Vec3 at, Vec3 normal) const;

 private:
  // What choices need of a group: its box, and its cones by sine and cosine.
  struct Node {
    Vec3 centre, half, axis;
    double radius_m, flux, cos_spread, sin_spread, cos_reach;
    std::uint32_t light;   // of a leaf
    std::uint32_t second;  // index of the second child, the first follows its parent; 0: a leaf
    std::uint32_t parent;
    bool is_even;
  };

  LightBounds build(std::span<const LightBounds> lights, std::span<std::uint32_t> of, std::uint32_t parent);
  static double importance(const Node& node, Vec3 at, Vec3 normal);
  double first_share(std::uint32_t node, Vec3 at, Vec3 normal) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_of_;  // per source; kNone without flux
};

}  // namespace citykiln::preview
