// The table of fields (fields.inc): sizes, lines and equipment by sport.
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

/// The ground that each of several courts takes; 0: an area has one field.
struct CourtSpace {
  double length_m, width_m;
};

/// Width and colour of lines.
struct LineStyle {
  double width_m;
  materials::TextureImage::Texel colour;
};

/// A row of fields.inc, where the columns are explained.
struct FieldRules {
  std::string_view name;    ///< Such as "Soccer".
  std::string_view sports;  ///< Values of sport=*, separated by blanks.
  SizeRange length, width;
  CourtSpace space;
  LineStyle line;
  std::string_view lines, equipment;
};

/// Returns the rows, in the order of FieldKind.
std::span<const FieldRules> field_rules();
/// Returns the row of a kind.
const FieldRules& rules_of(FieldKind kind);
/// True if a row is for this value of sport=*.
bool is_for(const FieldRules& rules, std::string_view sport);

/// Returns the size of a field on ground of this size; nothing if the ground is too small.
std::optional<double> fitted_m(const SizeRange& range, double ground_m);

}  // namespace citykiln::pitches
