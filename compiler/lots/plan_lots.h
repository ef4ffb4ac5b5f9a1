// Describes lots with buildings: the kind, frontage, frame and door of each lot that parcels/divide.h made. recipe.h
// has a picture of the frame.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/climate/climate_class.h"
#include "compiler/lots/land_of.h"
#include "compiler/lots/recipe.h"
#include "compiler/map/features.h"
#include "compiler/parcels/parcels.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// The name of a kind, such as "detached".
std::string_view name_of(LotKind kind);

/// Returns the frame at the place of a frontage that is nearest to the point `to`; nothing if no segment of the line
/// has a length. Its origin lies kUnderPavement_m inside the pavement, and its x axis has the direction of the line's
/// axis: it is left-handed on the right side of the line.
/// @param line  The line that the frontage lies along.
std::optional<Frame> frame_of(const parcels::Frontage& frontage, const parcels::Line& line, Vec2 to);

/// The door from which the path to the street begins.
struct Door {
  Vec2 at;                 ///< On the wall.
  Vec2 outward;            ///< Away from the wall, a unit vector.
  bool is_mapped = false;  ///< True for a mapped entrance or house number.
};

/// A lot with buildings.
struct Lot {
  parcels::Lot parcel;  ///< Its polygon has a coarse outline (coarse_outlines.h), and may be empty.
  LotKind kind{};
  map::CountryGroup country{};
  climate::ClimateClass climate{};
  std::uint32_t main = 0;                   ///< The main building: an index into Features::footprints.
  std::vector<std::uint32_t> footprints{};  ///< All buildings, as such indices.
  FramePlace frame{};    ///< At the point of the frontage that is nearest to the centroid of the main building.
  double setback_m = 0;  ///< The y of the main building's point nearest to the street, as in Yard.
  std::optional<Door> door{};
};

/// Returns the class of climate at a place of the plane.
using ClimateAt = std::function<climate::ClimateClass(Vec2)>;

/// Returns the lots with buildings, sorted by the ids of their main buildings.
///
/// A lot depends on what lies within parcels::kInfluenceRadius_m, and its kind on walls within 1 m and on the smallest
/// area of land use at its main building. O(n log n).
std::vector<Lot> plan_lots(const map::FeatureView& features, const MapLand& land, const parcels::Parcels& parcels,
                           const ClimateAt& climate_at, int threads);

}  // namespace citykiln::lots
