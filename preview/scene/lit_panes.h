// Lit panes: the lit windows of buildings whose meshes are not generated yet, as rectangles.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/vec.h"
#include "compiler/scene/scene.h"

namespace citykiln::preview {

/// A vertical rectangle of a building that shines outwards: a curtain, or the opening of a lit room.
struct LitPane {
  OsmId building;
  Vec3 corner;          ///< Lower left, seen from outside, plane metres.
  Vec2 along{1, 0};     ///< Unit; the outward normal is (along.y, -along.x).
  double width_m = 0;   ///< > 0.
  double height_m = 0;  ///< > 0.
  /// Mean luminance, approximately, as a share of materials::kEmission_cd_m2. Panes are sampled in proportion to it, so
  /// that only ratios matter. > 0.
  double luminance = 0;
};

/// The distance from the nearest eye beyond which buildings are left out.
inline constexpr double kLitNear_m = 400;

/// Returns the lit panes of the buildings near any of the eyes, in the order of the scene's chunks; by day none. Each
/// building is generated once, at a tolerance of 0.2 m, and its mesh dropped.
/// @param eyes  Plane metres.
std::vector<LitPane> lit_panes_of(const scene::Scene& scene, std::span<const Vec3> eyes, int threads);

}  // namespace citykiln::preview
