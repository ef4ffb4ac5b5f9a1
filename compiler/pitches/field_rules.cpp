#include "compiler/pitches/field_rules.h"

#include <algorithm>
#include <cassert>
#include <iterator>

#include "compiler/contract/texts/parse.h"
#include "compiler/roads/markings/mark.h"

namespace citykiln::pitches {
namespace {

constexpr materials::TextureImage::Texel kWhiteLine = {228, 228, 224}, kBlueLine = {38, 72, 160};

// A table's cell in parentheses, whose commas do not separate arguments.
#define FIELD_CELL(...) __VA_ARGS__
constexpr FieldRules kRows[] = {
#define FIELD(name, sports, length, width, space, line, lines, equipment) \
  {std::string_view(#name).substr(1),                                     \
   sports,                                                                \
   FIELD_CELL length,                                                     \
   FIELD_CELL width,                                                      \
   FIELD_CELL space,                                                      \
   FIELD_CELL line,                                                       \
   lines,                                                                 \
   equipment},
#include "compiler/pitches/fields.inc"
#undef FIELD
};
#undef FIELD_CELL
static_assert(std::size(kRows) == static_cast<std::size_t>(FieldKind::kCount));

}  // namespace

std::span<const FieldRules> field_rules() { return kRows; }

const FieldRules& rules_of(FieldKind kind) {
  assert(kind < FieldKind::kCount);
  return kRows[static_cast<std::size_t>(kind)];
}

bool is_for(const FieldRules& rules, std::string_view sport) {
  return std::ranges::count(split(rules.sports, ' '), sport) > 0;
}

std::optional<double> fitted_m(const SizeRange& range, double ground_m) {
  if (ground_m < range.least_m) return std::nullopt;
  return ground_m <= range.most_m ? ground_m : range.usual_m;
}

}  // namespace citykiln::pitches
