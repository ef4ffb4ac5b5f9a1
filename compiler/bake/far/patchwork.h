// The land cover around a scene: the cover along its edge, mirrored outwards.
//
//     ┌──────────┐
//     │ scene    │         A place some metres beyond the edge has the cover of the place as many metres inside of it,
//     │     a  b │ b  a    so the cover does not change at the edge. An offset by noise, which grows with the distance,
//     │          │         hides the symmetry.
//     └──────────┘
#pragma once

#include <optional>

#include "compiler/bake/ground/ground_tint.h"
#include "compiler/scene/ground_lookup.h"
#include "compiler/surroundings/generate.h"

namespace citykiln::bake {

/// The depth of the land along the edge that is mirrored, metres.
inline constexpr double kMirrored_m = 600;
/// The distance from the edge up to which woods have canopies, metres.
inline constexpr double kCanopies_m = 1500;
/// The height of canopies, metres.
inline constexpr double kCanopy_m = 11;

/// The land cover around a scene.
class Patchwork {
 public:
  /// @param lookup, header  Must outlive this object. The header has a grid of heights (Header::around).
  Patchwork(const scene::GroundLookup& lookup, const scene::Header& header);

  /// Returns the place in the scene that a place beyond its edge mirrors. Noise is not applied.
  Vec2 mirrored(Vec2 place) const;
  /// Returns by how much noise moves a place before it is mirrored: 0 at the edge.
  Vec2 shift_at(Vec2 place) const;
  /// Returns the box around the scene's tiles, at whose sides it is mirrored.
  const Box2& box() const { return lookup_.box(); }
  /// Returns the land cover of a cell: sea where the header's grid has sea; lakes only where land is level; no roads,
  /// buildings or sports grounds. Beyond kPatchesEnd_m all is meadow: colours do not depend on the cover
  /// there.
  /// Steep land where the scene has a town or nothing of known cover is scrub and wood.
  surroundings::Patch patch_of(const surroundings::Cell& cell, double away_m) const;
  /// Returns the land cover at a place on the border of tiles, without a canopy; empty where patch_of() does not go on
  /// with it.
  std::optional<surroundings::Patch> patch_on_border(Vec2 place) const;

 private:
  bool is_usable(const scene::GroundPlace& ground) const;
  bool is_lake(Vec2 from, Vec2 to, double away_m) const;
  double slope_at(Vec2 place) const;
  surroundings::Patch wild_at(Vec2 place, double height_m, double away_m) const;
  surroundings::Patch town_around(Vec2 from) const;
  surroundings::Patch patch_from(const scene::GroundPlace& ground, double height_m, double away_m) const;

  const scene::GroundLookup& lookup_;
  const scene::Header& header_;
};

}  // namespace citykiln::bake
