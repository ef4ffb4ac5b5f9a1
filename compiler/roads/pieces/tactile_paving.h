// Tactile paving: slabs with blisters at the kerbs of crossings, which blind people feel.
#pragma once

#include "compiler/map/countries/country_group.h"
#include "compiler/roads/markings/marking_layout.h"

namespace citykiln::roads {

/// The depth of the slabs behind the kerb, in metres: two rows of 0.4 m (Guidance on the use of tactile paving
/// surfaces, Department for Transport, 2021). Other countries have it too, although two feet
/// (0.61 m) are usual in America.
inline constexpr double kTactileDepth_m = 0.8;

/// True if crossings of a kind usually have tactile paving in a country. This is assumed, without a source.
/// @param stretch  kZebra, kCrossing, or kAlong for crossings without paint.
bool is_tactile_usual(map::CountryGroup country, StretchKind stretch);

/// Returns the slabs of a crossing as the layout of a panel that is depth_m wide. Slabs are red at painted and buff at
/// unpainted crossings of Britain and Ireland, yellow in America, Oceania, South and East Asia, light grey elsewhere.
/// @param stretch  kZebra, kCrossing, or kAlong for crossings without paint.
MarkingLayout tactile_layout(map::CountryGroup country, StretchKind stretch, double depth_m);

}  // namespace citykiln::roads
