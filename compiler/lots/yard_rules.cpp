#include "compiler/lots/yard_rules.h"

namespace citykiln::lots {
namespace {

using map::CountryGroup;
using map::LandCoverClass;

// The words for borders in yards.inc.
struct BorderWord {
  std::optional<map::BarrierKind> barrier{};
  map::FenceKind fence = map::FenceKind::kAny;
};
namespace borders {
using map::BarrierKind;
using map::FenceKind;
constexpr BorderWord kNone, kHedge{BarrierKind::kHedge}, kWall{BarrierKind::kWall}, kFence{BarrierKind::kFence},
    kBoards{BarrierKind::kFence, FenceKind::kBoards}, kPickets{BarrierKind::kFence, FenceKind::kPickets},
    kMesh{BarrierKind::kFence, FenceKind::kMesh};
}  // namespace borders

// The group of rows for all groups without rows of their own.
constexpr auto kAnywhere = CountryGroup::kCount;

struct YardRow {
  CountryGroup group;
  LotKind kind;
  std::uint32_t weight;
  LandCoverClass front, rear, path, drive;
  double drive_percent;
  BorderRule street, sides;
  double trees, shrubs;
};

#define YARD_ROW(group, kind, weight, front, rear, path, drive, percent, street, street_m, sides, sides_m, trees, \
                 shrubs)                                                                                          \
  {group,                                                                                                         \
   LotKind::kind,                                                                                                 \
   weight,                                                                                                        \
   LandCoverClass::front,                                                                                         \
   LandCoverClass::rear,                                                                                          \
   LandCoverClass::path,                                                                                          \
   LandCoverClass::drive,                                                                                         \
   percent,                                                                                                       \
   {borders::street.barrier, street_m, borders::street.fence},                                                    \
   {borders::sides.barrier, sides_m, borders::sides.fence},                                                       \
   trees,                                                                                                         \
   shrubs},
#define YARD(group, ...) YARD_ROW(CountryGroup::group, __VA_ARGS__)
#define YARD_ANYWHERE(...) YARD_ROW(kAnywhere, __VA_ARGS__)
constexpr YardRow kYardRows[] = {
#include "compiler/lots/yards.inc"
};
#undef YARD_ROW

std::uint32_t weight_of(CountryGroup group, LotKind kind) {
  std::uint32_t sum = 0;
  for (const YardRow& row : kYardRows)
    if (row.group == group && row.kind == kind) sum += row.weight;
  return sum;
}

const YardRow* drawn_row(CountryGroup group, LotKind kind, std::uint32_t drawn) {
  for (const YardRow& row : kYardRows) {
    if (row.group != group || row.kind != kind) continue;
    if (drawn < row.weight) return &row;
    drawn -= row.weight;
  }
  return nullptr;
}

// The front yard ends a little behind the front wall, below the house.
constexpr double kBehindFront_m = 0.25;

bool has_paved_front(const Yard& yard) {
  switch (yard.kind) {
    case LotKind::kPerimeter:
    case LotKind::kGreenCourt:
    case LotKind::kPavedCourt:
      return true;
    case LotKind::kApartments:
    case LotKind::kShop:
    case LotKind::kPublic:
      return yard.setback_m < kTownSetback_m;
    default:
      return false;
  }
}

// Changes a rule where it is dry.
void dry(YardRule& rule, const RandomSequence& draw) {
  if (rule.front == LandCoverClass::kLawn && draw.unit(2) < 0.5) rule.front = LandCoverClass::kGravelYard;
  if (rule.rear == LandCoverClass::kLawn && draw.unit(3) < 0.5) rule.rear = LandCoverClass::kEarthYard;
  rule.trees /= 2, rule.shrubs /= 2;
}

}  // namespace

bool is_planted(LandCoverClass surface) {
  return surface == LandCoverClass::kLawn || surface == LandCoverClass::kGravelYard ||
         surface == LandCoverClass::kEarthYard;
}

RandomSequence draws_of(const Yard& yard, std::uint64_t seed) { return {seed, stable_id(yard.building), "yard"}; }

std::optional<YardRule> rule_of(const Yard& yard, std::uint64_t seed) {
  const RandomSequence draw = draws_of(yard, seed);
  CountryGroup group = yard.country;
  if (weight_of(group, yard.kind) == 0) group = kAnywhere;
  const std::uint32_t weight = weight_of(group, yard.kind);
  if (weight == 0) return std::nullopt;
  const YardRow& row = *drawn_row(group, yard.kind, draw.below(weight, 0));
  YardRule rule{.front = row.front,
                .rear = row.rear,
                .path = row.path,
                .drive = row.drive,
                .front_m = yard.setback_m + kBehindFront_m,
                .has_drive = draw.unit(1) * 100 < row.drive_percent,
                .street = row.street,
                .sides = row.sides,
                .trees = row.trees,
                .shrubs = row.shrubs};
  if (yard.is_arid) dry(rule, draw);
  if (!has_paved_front(yard)) return rule;
  rule.is_paved_front = true, rule.front = LandCoverClass::kYardPath, rule.front_m = yard.setback_m + kRecess_m;
  return rule;
}

}  // namespace citykiln::lots
