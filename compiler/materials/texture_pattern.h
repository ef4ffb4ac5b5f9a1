// Procedural patterns of textures: brightness and relief, without colour.
#pragma once

#include "compiler/materials/noise.h"

namespace citykiln::materials {

/// The patterns, named after what they look like.
enum class TexturePattern : std::uint8_t {
  kBlades,   ///< Mown grass with clover, blades of 40 mm on 2 m.
  kTufts,    ///< Long grass, herbs and shrubs on 4 m.
  kRows,     ///< Drilled or ploughed fields, rows along v.
  kLitter,   ///< Fallen leaves of 80 mm and twigs on 4 m.
  kMottled,  ///< Trodden earth.
  kGrains,   ///< Fine grains.
  kStones,   ///< Gravel to scree.
  kCrags,    ///< Rock.
  kSlabs,    ///< Paving slabs of 0.5 m in half bond on 2 m.
  kAshlar,   ///< Courses of dressed stone, 667 × 333 mm on 4 m.
  // Bricks with their joints on 2 m: 250 × 83 mm (DIN 4172), 200 × 67 mm (US modular, three courses to 8 inches), and
  // 222 × 77 mm (225 × 75 by BS 4729, within 3 %).
  kBricks,         ///< Stretchers in half bond, DIN 4172.
  kModularBricks,  ///< Stretchers in half bond, US modular.
  kEnglishBond,    ///< Courses of stretchers and of headers in turn.
  kFlemishBond,    ///< Stretchers and headers in turn in each course.
  kStackBond,      ///< Stretchers above each other.
  kHeaderBond,     ///< Headers alone.
  kRubble,         ///< Split stones of about 0.3 m on 4 m, in mortar.
  kSetts,          ///< Setts of 0.1 m in rows on 2 m.
  kKerbs,          ///< Kerb stones 1 m long on 2 m; v runs along them.
  kPantiles,       ///< Roof tiles of 200 × 333 mm on 2 m; v runs up the roof.
  kSlates,         ///< Slates of 250 × 200 mm on 2 m.
  kShingles,       ///< Split shingles with an exposure of 125 mm on 2 m.
  kBoards,         ///< Lapped boards along u with an exposure of 154 mm on 2 m.
  kThatch,         ///< Reed along v on 2 m.
  kRender,         ///< Plaster with marks of the float, and stains.
  kShutters,       ///< Concrete of formwork panels, 1.33 × 2 m on 4 m.
  kCast,           ///< Brushed concrete.
  kCorrugations,   ///< Corrugated sheet along v, 77 mm apart on 2 m.
  kSeams,          ///< Sheet metal with standing seams along v, 0.5 m apart on 4 m.
  kFelt,           ///< Rolls of bitumen sheet along v, 1 m wide on 16 m, with patches and dried puddles.
  kGravelBed,      ///< Gravel of 16 to 32 mm on a roof of 8 m, with moss.
  kAsphalt,        ///< Asphalt.
  kWornAsphalt,    ///< Asphalt with cracks, some filled with bitumen.
  kLanes,    ///< Worn asphalt of two lanes along v, from gutter to gutter: four wheel tracks, a seam between lanes.
  kRipples,  ///< Sand with ripples along u, 0.1 m apart on 4 m.
  kWaves,    ///< Water; brightness is constant.
  kBars,     ///< A railing: eight bars along v below a rail, with holes between; brightness is constant.
  // Fences of 2 m, v up; what is above kFenceTop_px of 512 is not shown.
  kPalings,    ///< Upright boards of 117 mm with gaps of 8 mm.
  kPickets,    ///< Pointed pickets of 78 mm, 125 mm apart, before two rails; brightness is constant.
  kChainLink,  ///< Mesh of 62 mm with a post and a top rail; brightness is constant.
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

/// The top of fences in texels of 1/512 of the side of their patterns.
inline constexpr std::uint32_t kFenceTop_px = 500;

struct PatternFields {
  Field tone;    ///< Brightness: mean 0, standard deviation 1/2, clamped to -1 … 1; or all 0.
  Field relief;  ///< Height: mean 0, standard deviation 1.
  /// Opacity, 0 to 1, where there are holes; else without values.
  Field opacity{};
  /// Share of the material's second colour, 0 to 1, such as that of mortar; or without values.
  Field accent{};
  /// Difference from the material's roughness, as `tone`; or without values, where raised places are smoother.
  Field rough{};
};

/// Ways to lay bricks.
enum class Bond : std::uint8_t { kRunning, kEnglish, kFlemish, kStack, kHeader };

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
