// Parts that the patterns of textures are made of.
#pragma once

#include <cstdint>

#include "compiler/materials/texture_pattern.h"

namespace citykiln::materials {

/// Returns a field of zeros.
Field flat_field(std::uint32_t side_px);

/// Returns a field whose values are of(column, row).
template <typename Of>
Field combined(std::uint32_t side_px, Of of) {
  Field field = flat_field(side_px);
  for (std::uint32_t row = 0; row < side_px; ++row)
    for (std::uint32_t column = 0; column < side_px; ++column)
      field.at(column, row) = static_cast<float>(of(column, row));
  return field;
}

/// Returns a field scaled so that its mean is 0 and its standard deviation is 1 / deviations. Constant fields become 0.
Field normalised(Field field, double deviations);

/// Returns a field without most of its variation over more than a tenth of the side, by which one sees from afar that
/// it repeats.
Field fine(const Field& field);

/// Returns the fields of a pattern: its tone, normalised and clamped to -1 … 1, and its relief, normalised.
PatternFields tones(const Field& tone, const Field& relief);
/// Returns tones() of the fine part of the tone.
PatternFields fine_tones(const Field& tone, const Field& relief);
/// Returns fine_tones() of a field that is both tone and relief.
PatternFields fine_tones(const Field& both);

/// Returns 0 below at - width / 2, 1 above at + width / 2, and a straight ramp between.
double step(double value, double at, double width);

// The patterns of units in courses (pattern_courses.cpp), of sheets (pattern_sheets.cpp) and of single strokes
// (pattern_strokes.cpp): the fields of a square, as generate_pattern() returns them.
// @param px             The side of the square in texels.
// @param key            The random seed.
// @param across, along  The numbers of units along a side.
PatternFields bricks(Bond bond, std::uint32_t across, std::uint32_t along, std::uint32_t px, std::uint64_t key);
PatternFields ashlar(std::uint32_t px, std::uint64_t key);
PatternFields rubble(std::uint32_t px, std::uint64_t key);
PatternFields slabs(std::uint32_t px, std::uint64_t key);
PatternFields setts(std::uint32_t px, std::uint64_t key);
PatternFields kerbs(std::uint32_t px, std::uint64_t key);
PatternFields pantiles(std::uint32_t px, std::uint64_t key);
PatternFields slates(std::uint32_t px, std::uint64_t key);
PatternFields shingles(std::uint32_t px, std::uint64_t key);
PatternFields boards(std::uint32_t px, std::uint64_t key);

PatternFields render(std::uint32_t px, std::uint64_t key);
PatternFields shutters(std::uint32_t px, std::uint64_t key);
PatternFields corrugations(std::uint32_t px, std::uint64_t key);
PatternFields seams(std::uint32_t px, std::uint64_t key);
PatternFields felt(std::uint32_t px, std::uint64_t key);
PatternFields gravel_bed(std::uint32_t px, std::uint64_t key);
PatternFields asphalt(std::uint32_t px, std::uint64_t key);
PatternFields worn_asphalt(std::uint32_t px, std::uint64_t key);
PatternFields lanes(std::uint32_t px, std::uint64_t key);
PatternFields cast(std::uint32_t px, std::uint64_t key);
PatternFields ripples(std::uint32_t px, std::uint64_t key);

PatternFields blades(std::uint32_t px, std::uint64_t key);
PatternFields tufts(std::uint32_t px, std::uint64_t key);
PatternFields litter(std::uint32_t px, std::uint64_t key);
PatternFields thatch(std::uint32_t px, std::uint64_t key);

}  // namespace citykiln::materials
