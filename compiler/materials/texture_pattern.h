// What ground and walls look like from a step away, as light and dark and high and low, without colour.
#pragma once

#include "compiler/materials/noise.h"

namespace citykiln::materials {

enum class TexturePattern : std::uint8_t {
  kBlades,   ///< Short grass.
  kTufts,    ///< Long grass, shrubs.
  kRows,     ///< Drilled or ploughed, along v.
  kLitter,   ///< Leaves and twigs.
  kMottled,  ///< Trodden earth.
  kGrains,   ///< Sand, asphalt, concrete.
  kStones,   ///< Gravel to scree.
  kCrags,    ///< Rock.
  kSlabs,    ///< Paving, half a metre square on 4 m.
  kMasonry,  ///< Courses of stone along u.
  kBricks,   ///< Courses of bricks along u, a decimetre each on 2 m.
  kTiles,    ///< Rows of roof tiles along u, a third of a metre each on 2 m.
  kWaves,    ///< Of water; tone is flat.
  // bark, v along the stem
  kFurrows,    ///< Ridges along it that part and meet again: oak.
  kStreaks,    ///< Hardly any, across: beech.
  kLenticels,  ///< Dark dashes across, and scars: birch.
  kPlates,     ///< Of some decimetres: pine.
  kFlakes,     ///< Patches of what has come off at several times: plane.
  kScars       ///< Rings of leaves that were, a sixteenth apart: palm.
};

struct PatternFields {
  Field tone;    ///< Mean 0, two standard deviations 1 (all 0 where there is nothing to see), within -1 … 1.
  Field relief;  ///< Height, mean 0, standard deviation 1.
};

inline bool is_bark(TexturePattern pattern) { return pattern >= TexturePattern::kFurrows; }

/// Guarantees: repeats without a seam; nothing in it is longer than half a side, so that repeating does not show from
/// afar; a function of the arguments alone. O(texels).
PatternFields generate_pattern(TexturePattern pattern, std::uint32_t side_px, std::uint64_t key);

/// The field at fewer texels, of which each is the mean of those it takes the place of. @param side_px  Divides its
/// own.
Field downsampled(const Field& field, std::uint32_t side_px);

}  // namespace citykiln::materials
