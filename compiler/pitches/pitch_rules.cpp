#include "compiler/pitches/pitch_rules.h"

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
constexpr PitchRules kRows[] = {
#define PITCH(name, sports, length, width, space, line, lines, equipment) \
  {std::string_view(#name).substr(1),                                     \
   sports,                                                                \
   FIELD_CELL length,                                                     \
   FIELD_CELL width,                                                      \
   FIELD_CELL space,                                                      \
   FIELD_CELL line,                                                       \
   lines,                                                                 \
   equipment},
#include "compiler/pitches/pitches.inc"
#undef PITCH
};
#undef FIELD_CELL
static_assert(std::size(kRows) == static_cast<std::size_t>(PitchKind::kCount));

}  // namespace

std::span<const PitchRules> pitch_rules() { return kRows; }

const PitchRules& rules_of(PitchKind kind) {
  assert(kind < PitchKind::kCount);
  return kRows[static_cast<std::size_t>(kind)];
}

bool is_for(const PitchRules& rules, std::string_view sport) {
  return std::ranges::count(split(rules.sports, ' '), sport) > 0;
}

std::optional<double> fitted_m(const SizeRange& range, double ground_m) {
  if (ground_m < range.least_m) return std::nullopt;
  return ground_m <= range.most_m ? ground_m : range.usual_m;
}

}  // namespace citykiln::pitches
