// The recipe of a yard, Yard: what cannot be computed again from the yard's rule and the seed. draw_yard.h generates
// areas, barriers and plants from it.
//
//         rear            The frame of a yard: x runs along the street, y away from it. Its origin lies on the lot's
//     ┌──────────┐        border to the street, kUnderPavement_m (land_of.h) inside the pavement. The setback is the
//     │  ┌────┐  │        distance from there to the building.
//     │  │    │  │
//     │  └──D─┘  │ ┐      D the door
//   y ▲   front  │ │ setback_m
//    ═╧═►════════╧═╧═ street
//       x
//
// Coordinates are plane metres (compiler/map/plane/plane.h) or those of the frame, as stated.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/contract/stable_id.h"
#include "compiler/geometry/polygon.h"
#include "compiler/map/countries/country_group.h"

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
  kGreenCourt,  ///< A kPerimeter house in a block with much mapped green.
  kPavedCourt,  ///< A kPerimeter house in a block with much mapped paving.
  // The rest are no lots: ground that no lot has (compiler/vacant), which no recipe holds.
  kSchool,
  kChurch,
  kStorage,    ///< Yards of industry.
  kCarPark,    ///< Paved, without lines.
  kGreen,      ///< Rough grass.
  kAllotment,  ///< One plot of allotments.
  kSite,       ///< A building site.
  kCount
};

/// The frame of a lot: see the picture above. Right-handed if it is made by frame_at(); that of a street's right side
/// (frame_of(), plan_lots.h) is left-handed.
struct Frame {
  Vec2 origin;         ///< In metres of the plane.
  Vec2 along, inward;  ///< The directions of x and y, unit vectors.
  Vec2 local(Vec2 p) const { return {dot(p - origin, along), dot(p - origin, inward)}; }
  Vec2 plane(Vec2 p) const { return origin + along * p.x + inward * p.y; }
};

/// The grid spacing of the corners of lots, in metres.
inline constexpr double kOutlineStep_m = 0.25;
/// The grid spacing of frames' origins and of plants in the plane, and of places and lengths in a frame, in metres.
inline constexpr double kYardStep_m = 0.125;
/// The number of headings in a full turn. A heading is off by 0.18 degrees at most: 5 cm at 16 m.
inline constexpr int kHeadings = 1024;
/// The most features of one kind that a yard has; more are not drawn. Also the distance between ids of yards
/// (contract/derived_id.h).
inline constexpr std::uint32_t kPartsOfYard = 256;

/// The origin and heading of a yard's frame, on the grids of recipes.
struct FramePlace {
  Vec2 origin;                ///< In the plane, a multiple of kYardStep_m.
  std::uint16_t heading = 0;  ///< The direction of y, in kHeadings-ths of a full turn counter-clockwise of east.
  bool operator==(const FramePlace&) const = default;
};

/// Returns the frame at a place, right-handed. Bit-identical on all machines.
Frame frame_at(const FramePlace& place);
/// Returns the place whose frame is nearest to a frame: its origin is off by at most 0.71 · kYardStep_m, its heading by
/// 0.18 degrees. A left-handed frame has its x axis turned round. Bit-identical on all machines.
FramePlace place_of(const Frame& frame);

/// Returns the least y of a building's points in a frame, rounded down to a multiple of kYardStep_m, and at least 0.
/// 0 for an empty ring.
double setback_of(const Ring& building, const FramePlace& place);

/// A piece of the path to the door or of the drive.
struct YardStrip {
  bool is_drive = false;
  Vec2 from, to;  ///< The ends of its middle line in the yard's frame, multiples of kYardStep_m.
  bool operator==(const YardStrip&) const = default;
};

/// The part of a lot's border on which a barrier stands.
enum class BorderPlace : std::uint8_t {
  kStreet,     ///< Along a street, a little inside the lot. The barrier is YardRule::street.
  kFrontSide,  ///< At a side of the front yard, on the border. The barrier is YardRule::street.
  kElsewhere,  ///< At the other sides and the rear, on the border. The barrier is YardRule::sides.
  kCount
};

/// A barrier along the border of a lot: consecutive segments of its outer ring (border_segments() of draw_yard.h).
struct BorderRun {
  std::uint32_t first = 0, count = 0;  ///< The first segment, and how many. A run wraps at the end of the ring.
  BorderPlace place{};
  bool operator==(const BorderRun&) const = default;
};

/// A lot whose bounding box is larger in x or y, in metres, has no yard.
inline constexpr double kLargestYard_m = 2048;

/// The recipe of a yard.
struct Yard {
  ObjectId building;  ///< The main building. Its id and the seed pick among the rules for the next three.
  map::CountryGroup country{};
  LotKind kind{};
  bool is_arid = false;  ///< True in deserts and steppes.
  /// The lot in the plane: the outer ring counter-clockwise, holes clockwise, corners multiples of kOutlineStep_m.
  /// Rings may touch and cross.
  Polygon polygon{};
  FramePlace frame{};
  double setback_m = 0;   ///< The setback_of() the main building.
  bool has_bays = false;  ///< True if the front has bays for cars.
  std::vector<YardStrip> strips{};
  std::vector<BorderRun> borders{};
  std::vector<bool> plants{};  ///< Which of plants_drawn() stand. Missing values at the end are false.
  bool operator==(const Yard&) const = default;
};

}  // namespace citykiln::lots
