// The recipe of a yard: what its rule and the seed cannot draw. draw_yard.h makes areas, barriers and plants of it.
//
//        rear            y ▲      x runs along the street, y away from it
//     ┌─────────┐          │
//     │  ┌───┐  │          │
//     │  │   │  │ setback_m ┤
//     │  └─D─┘  │          │      D the door
//     │  front  │          └────► x
//    ═╧═════════╧═ street
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
  kCount
};

/// The frame of a lot: see the picture above. It is right-handed for yards.
struct Frame {
  Vec2 origin;         ///< In metres of the plane.
  Vec2 along, inward;  ///< The directions of x and y, unit vectors.
  Vec2 local(Vec2 p) const { return {dot(p - origin, along), dot(p - origin, inward)}; }
  Vec2 plane(Vec2 p) const { return origin + along * p.x + inward * p.y; }
};

/// The step of the corners of yards; that of places and lengths in the frame of a yard, of its origin and of its
/// plants; and the number of headings in a full turn. A heading is off by 0.18 degrees at most: 5 cm at 16 m.
inline constexpr double kOutlineStep_m = 0.25, kYardStep_m = 0.125;
inline constexpr int kHeadings = 1024;
/// The number of parts that the ids of a yard's features of one kind have (contract/derived_id.h).
inline constexpr std::uint32_t kPartsOfYard = 256;

/// The place of a yard's frame: `origin` is a multiple of kYardStep_m on the frontage, and y has this heading in
/// kHeadings-ths of a full turn counter-clockwise of east.
struct FramePlace {
  Vec2 origin;
  std::uint16_t heading = 0;
  bool operator==(const FramePlace&) const = default;
};

/// Returns the frame at a place. Every machine gives the same bits.
Frame frame_at(const FramePlace& place);
/// Returns the place whose frame is nearest to a frame; x changes its direction if the frame is left-handed.
FramePlace place_of(const Frame& frame);

/// Returns the y of a building's point that is nearest to the street, rounded down: 0 or a multiple of kYardStep_m.
double setback_of(const Ring& building, const FramePlace& place);

/// A piece of the path to the door or of the drive: the ends of its middle line in the frame, multiples of kYardStep_m.
struct YardStrip {
  bool is_drive = false;
  Vec2 from, to;
  bool operator==(const YardStrip&) const = default;
};

/// Where a barrier stands. The first two have the rule of the border to the street.
enum class BorderPlace : std::uint8_t {
  kStreet,     ///< Along a street, a little inside the lot.
  kFrontSide,  ///< At a side of the front yard.
  kElsewhere,  ///< At the sides and the rear.
  kCount
};

/// A barrier along the border of a yard: this many steps from a step on (border_steps() of draw_yard.h). It goes on at
/// the first step behind the last one.
struct BorderRun {
  std::uint32_t first = 0, count = 0;
  BorderPlace place{};
  bool operator==(const BorderRun&) const = default;
};

/// A lot whose box is wider or higher has no yard.
inline constexpr double kLargestYard_m = 2048;

/// The recipe of a yard. With the seed it decides everything that the yard has.
struct Yard {
  ObjectId building;  ///< The main building. With the seed it decides the rule and the plants.
  map::CountryGroup country{};
  LotKind kind{};
  bool is_arid = false;  ///< True in deserts and steppes.
  Polygon polygon{};     ///< The lot. Points are multiples of kOutlineStep_m; its rings may touch and cross.
  FramePlace frame{};
  double setback_m = 0;   ///< The setback_of() the main building.
  bool has_bays = false;  ///< True if the front has bays for cars.
  std::vector<YardStrip> strips{};
  std::vector<BorderRun> borders{};
  std::vector<bool> plants{};  ///< For each plant that the seed draws (plants_drawn()) whether it stands; else not.
  bool operator==(const Yard&) const = default;
};

}  // namespace citykiln::lots
