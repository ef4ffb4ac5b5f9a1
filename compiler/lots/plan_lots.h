// Describes lots with buildings: the kind, frontage, frame and door of each lot that parcels/divide.h made.
//
//        rear            y ▲      x runs along the street, y away from it, from kUnderPavement_m inside the pavement
//     ┌─────────┐          │
//     │  ┌───┐  │          │
//     │  │   │  │ setback_m ┤
//     │  └─D─┘  │          │      D the door: a mapped entrance, else the middle of the wall nearest to the street
//     │frontage │          └────► x
//    ═╧═════════╧═ street
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/climate/climate_class.h"
#include "compiler/lots/land_of.h"
#include "compiler/map/features.h"
#include "compiler/parcels/parcels.h"
#include "compiler/roads/recipe.h"

namespace citykiln::lots {

/// The kind of a lot, by land use and its main building. The order is that of outputs.
enum class LotKind : std::uint8_t {
  kDetached,    ///< A house that touches no other.
  kRow,         ///< A house in a row, or one half of two.
  kApartments,  ///< An apartment house that stands free.
  kPerimeter,   ///< A house of several storeys in a closed row of a block.
  kShop,        ///< Shops, offices, hotels.
  kWorks,       ///< Industry.
  kPublic,      ///< Churches, schools, public buildings.
  kNone,        ///< Others, such as garages and barns: no yard is assumed.
  kCount
};

/// The name of a kind, such as "detached".
std::string_view name_of(LotKind kind);

/// The frame of a lot: see the picture above. Its x axis has the direction of the line's axis, so that the frame is
/// left-handed for lots on the right side of the line. The origin is the point of the frontage that is nearest to the
/// centroid of the main building.
struct Frame {
  Vec2 origin;         ///< In metres of the plane.
  Vec2 along, inward;  ///< The directions of x and y, unit vectors.
  Vec2 local(Vec2 p) const { return {dot(p - origin, along), dot(p - origin, inward)}; }
  Vec2 plane(Vec2 p) const { return origin + along * p.x + inward * p.y; }
};

/// Returns the frame at the place of a frontage that is nearest to the point `to`; nothing if no segment of the line
/// has a length.
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
  parcels::Lot parcel;
  LotKind kind{};
  map::CountryGroup country{};
  climate::ClimateClass climate{};
  std::uint32_t main = 0;                   ///< The main building: an index into Features::footprints.
  std::vector<std::uint32_t> footprints{};  ///< All buildings, as such indices.
  Frame frame{};
  double setback_m = 0;  ///< The y of the main building's point nearest to the street, at least 0.
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
