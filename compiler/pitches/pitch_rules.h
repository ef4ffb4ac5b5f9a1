// The table of pitches (pitches.inc): sizes, lines and equipment by sport.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "compiler/materials/texture_image.h"
#include "compiler/pitches/recipe.h"

namespace citykiln::pitches {

/// The least, the usual and the largest value that a rule book allows.
struct SizeRange {
  double least_m, usual_m, most_m;
};

/// The ground that each of several courts takes; 0: an area has one pitch.
struct CourtSpace {
  double length_m, width_m;
};

/// Width and colour of lines.
struct LineStyle {
  double width_m;
  materials::TextureImage::Texel colour;
};

/// A row of pitches.inc, where the columns are explained.
struct PitchRules {
  std::string_view name;    ///< Such as "Soccer".
  std::string_view sports;  ///< Values of sport=*, separated by blanks.
  SizeRange length, width;
  CourtSpace space;
  LineStyle line;
  std::string_view lines, equipment;
};

/// Returns the rows, in the order of PitchKind.
std::span<const PitchRules> pitch_rules();
/// Returns the row of a kind.
const PitchRules& rules_of(PitchKind kind);
/// True if a row is for this value of sport=*.
bool is_for(const PitchRules& rules, std::string_view sport);

/// Returns the size of a pitch on ground of this size; nothing if the ground is too small.
std::optional<double> fitted_m(const SizeRange& range, double ground_m);

}  // namespace citykiln::pitches
