#include "compiler/buildings/lit_windows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "compiler/contract/random_sequence.h"
#include "compiler/map/buildings/building_classes.h"

namespace citykiln::buildings {
namespace {

using map::BuildingClass;

constexpr double kWeek_h = 168, kWeekend_h = 5 * 24;

struct UseRow {
  double unit_m, room_m, room_share;
  std::array<double, 24> weekday, weekend;
};

#define LIST(...) \
  { __VA_ARGS__ }
constexpr UseRow kUses[] = {
#define USE(name, unit_m, room_m, room_share, weekday, weekend) \
  {unit_m, room_m, room_share, LIST weekday, LIST weekend},
#include "compiler/buildings/lit_shares.inc"
#undef USE
};
#undef LIST
static_assert(std::size(kUses) == static_cast<std::size_t>(Use::kCount));

const UseRow& use_row(Use use) { return kUses[static_cast<std::size_t>(use)]; }

// Units switch up to so much earlier or later than the table says.
constexpr double kHabit_h = 0.75;

double wrapped(double hours) { return hours - kWeek_h * std::floor(hours / kWeek_h); }

double share_at_hour(const UseRow& row, std::int64_t hour) {
  const auto of_week = static_cast<std::size_t>(hour % static_cast<std::int64_t>(kWeek_h));
  return (of_week < static_cast<std::size_t>(kWeekend_h) ? row.weekday : row.weekend)[of_week % 24];
}

// Houses of more storeys have a household on each.
constexpr int kMaxFamilyLevels = 2;

Use use_by_style(Style style) {
  switch (style) {
    case Style::kOfficeSlab:
    case Style::kGlassTower:
      return Use::kOffice;
    case Style::kShop:
      return Use::kShop;
    case Style::kWarehouse:
    case Style::kBarn:
    case Style::kGarage:
      return Use::kIndustry;
    case Style::kChurch:
      return Use::kWorship;
    default:
      return Use::kHome;
  }
}

bool is_family_house(const Building& building) {
  switch (building.style) {
    case Style::kVilla:
    case Style::kRowHouse:
      return true;
    case Style::kNorthAmericanHouse:
    case Style::kJapaneseHouse:
    case Style::kBritishTerrace:
    case Style::kNordicWood:
    case Style::kMediterraneanHouse:
    case Style::kLatinAmericanHouse:
    case Style::kFlatRoofHouse:
    case Style::kTropicalHouse:
    case Style::kSouthAsianHouse:
      return building.levels <= kMaxFamilyLevels;
    default:
      return false;
  }
}

// A family's house is one household.
bool is_one_unit(const Building& building, Use use) {
  if (use_row(use).unit_m == 0) return true;
  return use == Use::kHome && is_family_house(building);
}

// The plan's cells lie along the longest edge of the building.
struct Cells {
  Vec2 origin, along;
  double floor_m, storey_m;
};

Cells cells_of(const Building& building) {
  const Ring& ring = building.footprint.outer;
  Vec2 longest{};
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i]; dot(edge, edge) > dot(longest, longest))
      longest = edge;
  // so that no border of a cell lies on the building's axes
  constexpr Vec2 kOff_m{0.731, 0.379};
  return {ring.front() - kOff_m, longest == Vec2{} ? Vec2{1, 0} : unit(longest), building.floor_m, storey_m(building)};
}

// The number of a cell with this side on its storey. Cells of one building that differ by 1024 m share a number.
std::uint32_t cell_at(const Cells& cells, Vec3 at, double side_m) {
  const Vec2 from = in_plan(at) - cells.origin;
  const auto number = [](double v) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(std::floor(v))); };
  const std::uint32_t x = number(dot(from, cells.along) / side_m), y = number(dot(from, left_of(cells.along)) / side_m),
                      storey = number((at.z - cells.floor_m) / cells.storey_m);
  return (storey & 0xff) << 24 | (y & 0xfff) << 12 | (x & 0xfff);
}

Vec3 middle_of(const grammars::Scope& scope) {
  Vec3 middle = scope.origin;
  for (int i = 0; i < 3; ++i) middle = middle + scope.axis[i] * (scope.size_m[i] / 2);
  return middle;
}

bool is_on(Use use, WeekTime time, const RandomSequence& draw, std::uint32_t unit, std::optional<double> given) {
  if (given) return draw.unit(2 * unit + 1) < *given;
  const double habit_h = draw.between(-kHabit_h, kHabit_h, 2 * unit);
  return draw.unit(2 * unit + 1) < lit_share(use, {wrapped(time.hours + habit_h)});
}

// True if a front is open at an hour of the week, opening and closing so much earlier and later.
bool is_open_at(const map::FrontHours& hours, double of_week_h, double early_h, double late_h) {
  // the day, and the one before: some close after midnight
  for (const int back : {0, 1}) {
    const int day = (static_cast<int>(std::floor(of_week_h / 24)) - back + 7) % 7, row = day < 5 ? 0 : day - 4;
    const double open_h = hours.quarters[2 * row] / 4.0, close_h = hours.quarters[2 * row + 1] / 4.0;
    const double at_h = of_week_h - 24 * std::floor(of_week_h / 24) + 24 * back;
    if (open_h < close_h && at_h >= open_h - early_h && at_h < close_h + late_h) return true;
  }
  return false;
}

StableId id_of(const Building& building) { return stable_id(building.id); }

}  // namespace

Use use_of(const Building& building) {
  switch (static_cast<BuildingClass>(building.building_class)) {
    case BuildingClass::kHotel:
      return Use::kHotel;
    case BuildingClass::kSchool:
      return Use::kSchool;
    case BuildingClass::kHospital:
      return Use::kHospital;
    case BuildingClass::kCivic:
    case BuildingClass::kOffice:
      return Use::kOffice;
    case BuildingClass::kHall:
      return Use::kIndustry;
    default:
      return use_by_style(building.style);
  }
}

double lit_share(Use use, WeekTime time) {
  const UseRow& row = use_row(use);
  const double hours = wrapped(time.hours), before = std::floor(hours), part = hours - before;
  const auto hour = static_cast<std::int64_t>(before);
  return share_at_hour(row, hour) * (1 - part) + share_at_hour(row, hour + 1) * part;
}

double lit_window_share(Use use, WeekTime time) { return lit_share(use, time) * use_row(use).room_share; }

grammars::AnswerContextQuery lit_windows(const Building& building, WeekTime time, std::uint64_t seed,
                                         std::optional<double> given) {
  const Use use = use_of(building);
  return [=, cells = cells_of(building), whole = is_one_unit(building, use),
          units = RandomSequence(seed, id_of(building), "lit unit"),
          rooms = RandomSequence(seed, id_of(building), "lit room")](grammars::ContextQuery query,
                                                                     const grammars::Shape& shape) {
    if (query != grammars::ContextQuery::kIsLit) return false;
    const UseRow& row = use_row(use);
    const Vec3 at = middle_of(shape.scope);
    const bool is_lit_room =
        given || row.room_share == 1 || rooms.unit(cell_at(cells, at, row.room_m)) < row.room_share;
    return is_lit_room && is_on(use, time, units, whole ? 0 : cell_at(cells, at, row.unit_m), given);
  };
}

bool is_front_lit(const Building& building, std::uint32_t front, WeekTime time, std::uint64_t seed,
                  std::optional<double> given) {
  constexpr double kEarly_h = 0.5, kLate_h = 0.75, kWindowsFrom_h = 15, kWindowsUntil_h = 23.5;
  const map::FrontValues& values = map::values_of(building.fronts[front].kind);
  const RandomSequence draw(seed, id_of(building), "lit front");
  if (given) return draw.unit(3 * front + 2) < *given;
  const double hours = wrapped(time.hours), of_day = hours - 24 * std::floor(hours / 24);
  if (is_open_at(building.fronts[front].hours.value_or(values.hours), hours, draw.between(0, kEarly_h, 3 * front),
                 draw.between(0, kLate_h, 3 * front + 1)))
    return true;
  const bool has_lit_window = draw.unit(3 * front + 2) < values.lit_share;
  return has_lit_window && of_day >= kWindowsFrom_h && of_day < kWindowsUntil_h;
}

bool is_shop_lit(const Building& building, WeekTime time, std::uint64_t seed, std::optional<double> given) {
  return is_on(Use::kShop, time, RandomSequence(seed, id_of(building), "lit shop"), 0, given);
}

}  // namespace citykiln::buildings
