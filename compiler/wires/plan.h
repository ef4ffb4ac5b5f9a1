// Plans the wires of power lines: which supports hold them, where they hang, and how far they sag.
//
//      |        support                 The attachments of a support are drawn by its rules. A wire joins attachments
//    --+--  o----____      ___----o     of two supports, left with left and upper with upper. It sags as its class
//      |             -----              does, or less, if it would come too near to the ground or a road.
#pragma once

#include <span>
#include <vector>

#include "compiler/contract/findings/report.h"
#include "compiler/ground/grading/graded_terrain.h"
#include "compiler/map/features.h"
#include "compiler/roads/recipe.h"
#include "compiler/structures/recipe.h"
#include "compiler/things/catalogue.h"
#include "compiler/things/recipe.h"
#include "compiler/wires/recipe.h"

namespace citykiln::wires {

/// The longest distance between two supports, in plan. Longer spans are not built, kSpanTooLong.
inline constexpr double kLongestSpan_m = 1024;
/// The radius of influence: a span belongs to the tile of its middle.
inline constexpr double kSpanRadius_m = kLongestSpan_m / 2;

/// The height above a carriageway below which no wire hangs, and above a bridge.
inline constexpr double kLeastOverRoad_m = 4.5;

/// The data that spans depend on, besides the map.
struct Surroundings {
  std::span<const map::ThingFeature> mapped;  ///< The features of these things.
  std::span<const things::Thing> things;      ///< Sorted by id.
  std::span<const things::Thing> beyond;      ///< Supports outside of the extent, sorted by id.
  const things::Kinds& kinds;                 ///< The kinds of both.
  std::span<const roads::Road> roads;         ///< On the ground.
  std::span<const structures::Span> bridges;
  const ground::GradedTerrain& ground;  ///< The graded terrain of the whole map.
  std::uint64_t seed = 0;
};

/// Returns the wires of power lines, sorted by id: one span for each two supports that follow each other on a way.
/// Nodes without a support hold nothing: wires go straight past them. A support that is mapped but was not built ends
/// the wires. Two supports have one span, that of the first way.
///
/// The conductors are as many as cables=* or circuits=* says and both supports hold; if nothing is tagged, as many as
/// both hold. Sag follows from the class: span² / (8 c), where c is the horizontal tension over the weight per metre.
/// It is less where a wire would come nearer to the ground or a bridge than its class allows, but at least 0.5 % of the
/// span. A span that is then too low over a carriageway, or touches the ground, is dropped, kWireTooLow.
///
/// Ledger "wires/span". O(spans · length).
std::vector<WireSpan> plan(const map::FeatureView& features, const Surroundings& around, Report& report);

}  // namespace citykiln::wires
