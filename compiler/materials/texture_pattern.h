// Procedural patterns of textures: brightness and relief, without colour.
#pragma once

#include "compiler/materials/noise.h"

namespace citykiln::materials {

/// The patterns, named after what they look like.
enum class TexturePattern : std::uint8_t {
  kBlades,   ///< Short grass.
  kTufts,    ///< Long grass, shrubs.
  kRows,     ///< Drilled or ploughed fields, rows along v.
  kLitter,   ///< Leaves and twigs.
  kMottled,  ///< Trodden earth.
  kGrains,   ///< Sand, asphalt, concrete.
  kStones,   ///< Gravel to scree.
  kCrags,    ///< Rock.
  kSlabs,    ///< Paving slabs of 0.5 m if the texture's side is 4 m.
  kMasonry,  ///< Courses of stone along u.
  kBricks,   ///< Courses of bricks along u, 77 mm high if the side is 2 m.
  kTiles,    ///< Rows of roof tiles along u, 1/3 m high if the side is 2 m.
  kWaves,    ///< Water; brightness is constant.
  kBars,     ///< A railing: eight bars along v below a rail, with holes between; brightness is constant.
  // Bark; v runs along the stem.
  kFurrows,    ///< Ridges along the stem that part and join: oak.
  kStreaks,    ///< Faint streaks across the stem: beech.
  kLenticels,  ///< Dark dashes across, and scars: birch.
  kPlates,     ///< Plates of some decimetres: pine.
  kFlakes,     ///< Patches of bark shed at different times: plane.
  kScars       ///< Rings of leaf scars, a sixteenth of the side apart: palm.
};

/// The texture of TexturePattern::kBars in texels of 1/256 of its side, u across the bars, v up from the gap below
/// them. Faces show it from v = kRailingLow_px to kRailingHigh_px, so that filters do not mix its ends.
/// A bar is kBar_px wide; the first one begins at u = kBarBegin_px. Bars stand from v = kBarsFrom_px to the rail, which
/// begins at v = kRailFrom_px.
inline constexpr std::uint32_t kBarPitch_px = 32, kBarBegin_px = 17, kBar_px = 5;
inline constexpr std::uint32_t kRailingLow_px = 8, kBarsFrom_px = 27, kRailFrom_px = 236, kRailingHigh_px = 248;

struct PatternFields {
  Field tone;    ///< Brightness: mean 0, standard deviation 1/2, clamped to -1 … 1; or all 0.
  Field relief;  ///< Height: mean 0, standard deviation 1.
  /// Opacity, 0 to 1, where there are holes; else without values.
  Field opacity{};
};

inline bool is_bark(TexturePattern pattern) { return pattern >= TexturePattern::kFurrows; }

/// Returns the fields of a pattern, side_px > 0.
///
/// Guarantees: repeats without a seam; features are shorter than half a side, so that the repetition is not visible
/// from afar; a function of the arguments alone. O(texels).
PatternFields generate_pattern(TexturePattern pattern, std::uint32_t side_px, std::uint64_t key);

/// Returns the field at a lower resolution: each value is the mean of the values that it replaces.
/// @param side_px  A divisor of the field's side_px.
Field downsampled(const Field& field, std::uint32_t side_px);

}  // namespace citykiln::materials
