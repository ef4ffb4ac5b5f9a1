#include "compiler/assume/heights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"

namespace citykiln::assume {
namespace {

using map::BuildingClass;
using map::CountryGroup;
using map::LandCoverClass;

// ---- the table ------------------------------------------------------------------------------------------------------

// Sets of classes, groups of countries and land uses: sums of bits.
#define BUILDING(name, height_m, level_m) constexpr std::uint32_t name = 1u << static_cast<int>(BuildingClass::name);
namespace of_class {
#include "compiler/map/buildings/building_classes.inc"
}
#undef BUILDING
namespace of_group {
constexpr std::uint32_t bit(CountryGroup group) { return 1u << static_cast<int>(group); }
constexpr std::uint32_t kCentralEurope = bit(CountryGroup::kCentralEurope),
                        kSouthernEurope = bit(CountryGroup::kSouthernEurope),
                        kBritishIsles = bit(CountryGroup::kBritishIsles),
                        kNorthAmerica = bit(CountryGroup::kNorthAmerica), kJapan = bit(CountryGroup::kJapan);
}  // namespace of_group
namespace of_use {
constexpr std::uint32_t bit(SiteUse use) { return 1u << static_cast<int>(use); }
constexpr std::uint32_t kNoUse = bit(SiteUse::kNoUse), kHomes = bit(SiteUse::kHomes), kTrade = bit(SiteUse::kTrade),
                        kIndustry = bit(SiteUse::kIndustry), kCountry = bit(SiteUse::kCountry);
}  // namespace of_use

constexpr std::uint32_t kAnyBit = ~0u;
constexpr double kNoLimit = 1e9;

// A row holds for values from `…_from` on, below `…_to`.
struct StoreyConditions {
  std::uint32_t classes = kAnyBit, groups = kAnyBit, uses = kAnyBit;
  double area_from = 0, area_to = kNoLimit, touching_from = 0, touching_to = kNoLimit;
  double built_from = 0, built_to = kNoLimit, mean_area_from = 0, mean_area_to = kNoLimit;
  double shops_from = 0, shops_to = kNoLimit, row_share_from = 0, row_share_to = kNoLimit;
};

struct StoreyRow {
  StoreyConditions when;
  StoreyQuartiles storeys;
};

const StoreyRow* storey_rows(std::size_t& count) {
  using namespace of_class;
  using namespace of_group;
  using namespace of_use;
  static constexpr StoreyRow kRows[] = {
#define STOREYS(low, middle, high, buildings, places, ...) {{__VA_ARGS__}, {low, middle, high}},
#include "compiler/assume/storeys.inc"
#undef STOREYS
  };
  count = std::size(kRows);
  return kRows;
}

// The group whose buildings stand for those of a group without tagged examples.
CountryGroup measured_group(CountryGroup group) {
  switch (group) {
    case CountryGroup::kNorthernEurope:
    case CountryGroup::kEasternEurope:
      return CountryGroup::kCentralEurope;
    case CountryGroup::kTropicalAfrica:
    case CountryGroup::kOceania:
      return CountryGroup::kNorthAmerica;
    case CountryGroup::kSouthEastAsia:
      return CountryGroup::kJapan;
    case CountryGroup::kLatinAmerica:
    case CountryGroup::kNorthAfricaAndMiddleEast:
    case CountryGroup::kSouthAsia:
    case CountryGroup::kChina:
      return CountryGroup::kSouthernEurope;
    default:
      return group;
  }
}

bool lies_within(double value, double from, double to) { return value >= from && value < to; }

bool holds(const StoreyConditions& c, const HeightFacts& f) {
  return (c.classes >> static_cast<int>(f.building_class) & 1) != 0 &&
         (c.groups & of_group::bit(measured_group(f.country))) != 0 && (c.uses & of_use::bit(f.use)) != 0 &&
         lies_within(f.area_m2, c.area_from, c.area_to) &&
         lies_within(f.touching_count, c.touching_from, c.touching_to) &&
         lies_within(f.built_share, c.built_from, c.built_to) &&
         lies_within(f.mean_area_m2, c.mean_area_from, c.mean_area_to) &&
         lies_within(f.shops, c.shops_from, c.shops_to) && lies_within(f.row_share, c.row_share_from, c.row_share_to);
}

// ---- surroundings ---------------------------------------------------------------------------------------------------

// Smaller outlines are no buildings.
constexpr double kLeastArea_m2 = 4;
constexpr double kBucket_m = 64;

double class_level_m(BuildingClass building_class) { return map::values_of(building_class).level_m; }
BuildingClass class_of(const map::Footprint& f) { return static_cast<BuildingClass>(f.building_class); }

bool is_outline(const map::Footprint& f) {
  return !f.is_part && !f.outline && f.polygon.outer.size() >= 3 && area_m2(f.polygon) > kLeastArea_m2;
}

SiteUse use_of(LandCoverClass surface) {
  switch (surface) {
    case LandCoverClass::kResidential:
      return SiteUse::kHomes;
    case LandCoverClass::kCommercial:
    case LandCoverClass::kRetail:
      return SiteUse::kTrade;
    case LandCoverClass::kIndustrial:
    case LandCoverClass::kRailwayLand:
    case LandCoverClass::kPort:
      return SiteUse::kIndustry;
    case LandCoverClass::kFarmland:
    case LandCoverClass::kFarmyard:
    case LandCoverClass::kMeadow:
    case LandCoverClass::kForest:
    case LandCoverClass::kAllotments:
    case LandCoverClass::kOrchard:
      return SiteUse::kCountry;
    default:
      return SiteUse::kNoUse;
  }
}

// Sets the use of the smallest area with one under each building.
void set_uses(const map::FeatureView& features, HeightIndex& index) {
  std::vector<const map::AreaFeature*> areas;
  std::vector<Box2> boxes;
  for (const map::AreaFeature& area : features.areas) {
    if (use_of(area.surface) == SiteUse::kNoUse || area.polygon.outer.empty()) continue;
    areas.push_back(&area), boxes.push_back(box_of(area.polygon.outer));
  }
  if (areas.empty()) return;
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  for (std::size_t i = 0; i < index.at.size(); ++i) {
    const map::AreaFeature* smallest = nullptr;
    for (const std::uint32_t k : boxes_about(grid, index.at[i])) {
      const bool is_smaller =
          !smallest || std::pair(areas[k]->area_m2, areas[k]->id) < std::pair(smallest->area_m2, smallest->id);
      if (is_smaller && boxes[k].contains(index.at[i]) && contains(areas[k]->polygon, index.at[i])) smallest = areas[k];
    }
    if (smallest) index.facts[i].use = use_of(smallest->surface);
  }
}

// Counts the corners of a ring on the border of another, up to two.
int corners_on(const Ring& ring, const Ring& other, const Box2& box) {
  int count = 0;
  for (const Vec2 p : ring)
    if (box.contains(p) && distance_to_ring(other, p) <= kHeightTouching_m && ++count == 2) break;
  return count;
}

// Two buildings touch if at least two of their corners lie on the other's wall.
bool do_touch(const Ring& a, const Ring& b) {
  const Box2 about_a = box_of(a).widened(kHeightTouching_m), about_b = box_of(b).widened(kHeightTouching_m);
  return corners_on(a, b, about_b) + corners_on(b, a, about_a) >= 2;
}

void set_touching(const map::FeatureView& features, HeightIndex& index) {
  const auto ring = [&](std::size_t i) -> const Ring& {
    return features.footprints[index.footprints[i]].polygon.outer;
  };
  std::vector<Box2> boxes;
  for (std::size_t i = 0; i < index.footprints.size(); ++i) boxes.push_back(box_of(ring(i)).widened(kHeightTouching_m));
  const BoxGrid grid = grid_of(boxes, kBucket_m);
  index.touching.resize(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (const std::uint32_t k : boxes_about(grid, boxes[i])) {
      if (k <= i || !boxes[i].touches(boxes[k]) || !do_touch(ring(i), ring(k))) continue;
      index.touching[i].push_back(k), index.touching[k].push_back(i);
    }
  }
}

// The entries within a radius of a place, ascending.
std::vector<std::uint32_t> entries_within(const HeightIndex& index, Vec2 p, double radius_m) {
  std::vector<std::uint32_t> entries = boxes_about(index.grid, Box2{p, p}.widened(radius_m));
  std::erase_if(entries, [&](std::uint32_t k) { return distance(index.at[k], p) > radius_m; });
  return entries;
}

void set_surroundings(HeightIndex& index) {
  constexpr double kCircle_m2 = std::numbers::pi * kHeightSurroundings_m * kHeightSurroundings_m;
  for (std::size_t i = 0; i < index.at.size(); ++i) {
    const std::vector<std::uint32_t> near = entries_within(index, index.at[i], kHeightSurroundings_m);
    double sum_m2 = 0, in_rows = 0;
    for (const std::uint32_t k : near) sum_m2 += index.facts[k].area_m2, in_rows += !index.touching[k].empty();
    const double count = static_cast<double>(near.size());
    HeightFacts& facts = index.facts[i];
    facts.touching_count = static_cast<std::uint32_t>(index.touching[i].size());
    facts.built_share = sum_m2 / kCircle_m2, facts.mean_area_m2 = sum_m2 / count, facts.row_share = in_rows / count;
  }
}

void count_shops(const map::FeatureView& features, HeightIndex& index) {
  for (const map::PointFeature& point : features.points) {
    if (point.kind != map::PointKind::kShop) continue;
    for (const std::uint32_t k : entries_within(index, point.at, kHeightSurroundings_m)) ++index.facts[k].shops;
  }
}

// The pitched roof that the tagged height of a single house includes; TABULA has 2 to 4 m over the eaves.
double included_roof_m(const HeightFacts& facts) {
  const BuildingClass c = facts.building_class;
  const bool is_dwelling = c == BuildingClass::kHouse || c == BuildingClass::kPlain || c == BuildingClass::kApartments;
  return is_dwelling && facts.touching_count == 0 && facts.area_m2 >= 40 && facts.area_m2 <= 350 ? 2 : 0;
}

constexpr double kMostStoreys = 60;

double whole_storeys(double storeys) { return std::clamp(std::floor(storeys + 0.5), 1.0, kMostStoreys); }

double tagged_storeys(const map::Footprint& f, const HeightFacts& facts) {
  if (has(f.assumed, Assumption::kHouses) || f.has_default_height || f.min_height_m > 0 ||
      !has_assumed_storeys(facts.building_class))
    return 0;
  if (!f.has_roof_in_height) return f.levels > 0 ? whole_storeys(f.levels) : 0;
  return whole_storeys((f.height_m - included_roof_m(facts)) / class_level_m(facts.building_class));
}

// ---- neighbours -----------------------------------------------------------------------------------------------------

// How much a tagged neighbour counts beside the table, which counts kTable: by distance, class, area, and whether the
// two touch. Fitted by tests/bench/train_heights.py.
constexpr double kTable = 0.3, kHalf_m = 60, kOtherClass = 0.4, kTouching = 2;

struct Vote {
  double storeys, weight;
  auto operator<=>(const Vote&) const = default;
};

double vote_weight(std::uint32_t i, std::uint32_t k, const HeightIndex& index) {
  const HeightFacts &a = index.facts[i], &b = index.facts[k];
  const double far = distance(index.at[i], index.at[k]) / kHalf_m;
  const bool is_touching = std::ranges::binary_search(index.touching[i], k);
  return std::min(a.area_m2, b.area_m2) / std::max(a.area_m2, b.area_m2) / (1 + far * far) *
         (a.building_class == b.building_class ? 1 : kOtherClass) * (is_touching ? kTouching : 1);
}

// The value at a share of the weight of sorted votes.
double vote_at(std::span<const Vote> votes, double share) {
  double rest = 0;
  for (const Vote& vote : votes) rest += share * vote.weight;
  for (const Vote& vote : votes) {
    rest -= vote.weight;
    if (rest <= 0) return vote.storeys;
  }
  return votes.back().storeys;
}

// ---- rows -----------------------------------------------------------------------------------------------------------

// The entries of a row about one of them: linked by shared walls, none farther than kHeightRow_m.
std::vector<std::uint32_t> row_about(std::uint32_t entry, const HeightIndex& index) {
  std::vector<std::uint32_t> row{entry};
  for (std::size_t i = 0; i < row.size(); ++i)
    for (const std::uint32_t next : index.touching[row[i]])
      if (distance(index.at[next], index.at[entry]) <= kHeightRow_m && std::ranges::find(row, next) == row.end())
        row.push_back(next);
  return row;
}

double drawn(const StoreyQuartiles& storeys, double draw) {
  return draw < 0.25 ? storeys.low : draw < 0.75 ? storeys.middle : storeys.high;
}

// ---- writing --------------------------------------------------------------------------------------------------------

bool follows_outline(const map::Footprint& f) {
  return f.outline && f.has_default_height && class_of(f) != BuildingClass::kSteps;
}

// Outlines with a part that begins above the ground.
std::set<ObjectId> raised_outlines(std::span<const map::Footprint> footprints) {
  std::set<ObjectId> raised;
  for (const map::Footprint& f : footprints)
    if (f.outline && f.min_height_m > 0) raised.insert(*f.outline);
  return raised;
}

bool is_silent(const map::Footprint& f) {
  return f.has_default_height && f.min_height_m == 0 && !f.is_open && has_assumed_storeys(class_of(f));
}

void set_storeys(double storeys, map::Footprint& f) {
  f.levels = storeys;
  f.height_m = snapped(storeys * class_level_m(class_of(f)));
  f.has_roof_in_height = f.has_default_height = false;
  f.assumed |= bit_of(Assumption::kHeights);
}

void set_as_outline(const map::Footprint& outline, map::Footprint& f) {
  if (outline.height_m <= f.min_height_m) return;
  f.levels = outline.levels, f.height_m = outline.height_m;
  f.has_roof_in_height = f.has_default_height = false;
  f.assumed |= bit_of(Assumption::kHeights);
}

// The storeys of all outlines whose tags are silent.
std::map<ObjectId, double> assumed_storeys(const map::FeatureView& features, std::uint64_t seed) {
  const HeightIndex index = index_heights(features);
  const std::set<ObjectId> raised = raised_outlines(features.footprints);
  std::map<ObjectId, double> storeys;
  for (std::uint32_t i = 0; i < index.footprints.size(); ++i) {
    const map::Footprint& f = features.footprints[index.footprints[i]];
    if (!is_silent(f) || raised.contains(f.id)) continue;
    const ObjectId member = drawing_member(i, features, index, seed);
    storeys[f.id] = drawn(storeys_of(i, index), RandomSequence(seed, stable_id(member), "storeys").unit(0));
  }
  return storeys;
}

}  // namespace

bool has_assumed_storeys(BuildingClass building_class) {
  switch (building_class) {
    case BuildingClass::kPlain:
    case BuildingClass::kHouse:
    case BuildingClass::kApartments:
    case BuildingClass::kOffice:
    case BuildingClass::kShop:
    case BuildingClass::kHall:
    case BuildingClass::kBarn:
    case BuildingClass::kCivic:
    case BuildingClass::kHotel:
    case BuildingClass::kSchool:
    case BuildingClass::kHospital:
      return true;
    default:
      return false;
  }
}

StoreyQuartiles storeys_by_table(const HeightFacts& facts) {
  std::size_t count = 0;
  const StoreyRow* rows = storey_rows(count);
  for (const StoreyRow& row : std::span(rows, count))
    if (holds(row.when, facts)) return row.storeys;
  return {};
}

HeightIndex index_heights(const map::FeatureView& features) {
  HeightIndex index;
  std::vector<Box2> points;
  for (std::uint32_t i = 0; i < features.footprints.size(); ++i) {
    const map::Footprint& f = features.footprints[i];
    if (!is_outline(f)) continue;
    index.footprints.push_back(i);
    index.at.push_back(centroid(f.polygon));
    index.facts.push_back({.building_class = class_of(f), .country = f.country, .area_m2 = area_m2(f.polygon)});
    points.push_back({index.at.back(), index.at.back()});
  }
  if (points.empty()) return index;
  index.grid = grid_of(points, kBucket_m);
  set_uses(features, index);
  set_touching(features, index);
  set_surroundings(index);
  count_shops(features, index);
  for (std::size_t i = 0; i < index.footprints.size(); ++i)
    index.tagged_storeys.push_back(tagged_storeys(features.footprints[index.footprints[i]], index.facts[i]));
  return index;
}

StoreyQuartiles storeys_of(std::uint32_t entry, const HeightIndex& index,
                           const std::function<bool(std::uint32_t entry)>& may_use_tags) {
  assert(entry < index.at.size());
  const StoreyQuartiles table = storeys_by_table(index.facts[entry]);
  // a little more than a quarter each, so that without neighbours the quartiles are those of the table
  std::vector<Vote> votes{{table.low, 0.3 * kTable}, {table.middle, 0.4 * kTable}, {table.high, 0.3 * kTable}};
  for (const std::uint32_t k : entries_within(index, index.at[entry], kHeightNeighbours_m)) {
    if (k == entry || index.tagged_storeys[k] == 0 || (may_use_tags && !may_use_tags(k))) continue;
    votes.push_back({index.tagged_storeys[k], vote_weight(entry, k, index)});
  }
  std::ranges::sort(votes);
  return {vote_at(votes, 0.25), vote_at(votes, 0.5), vote_at(votes, 0.75)};
}

ObjectId drawing_member(std::uint32_t entry, const map::FeatureView& features, const HeightIndex& index,
                        std::uint64_t seed) {
  std::pair<double, ObjectId> least{2, {}};
  for (const std::uint32_t k : row_about(entry, index)) {
    const ObjectId id = features.footprints[index.footprints[k]].id;
    least = std::min(least, std::pair(RandomSequence(seed, stable_id(id), "row").unit(0), id));
  }
  return least.second;
}

std::vector<map::Footprint> assume_heights(const map::FeatureView& features, std::uint64_t seed, Report& report) {
  const std::map<ObjectId, double> storeys = assumed_storeys(features, seed);
  std::vector<map::Footprint> footprints(features.footprints.begin(), features.footprints.end());
  std::set<OsmId> counted;
  std::map<ObjectId, const map::Footprint*> outlines;
  for (map::Footprint& f : footprints) {
    const auto found = storeys.find(f.id);
    if (found == storeys.end()) continue;
    set_storeys(found->second, f);
    outlines.emplace(f.id, &f);
    if (counted.insert(f.id.osm).second) report.count_assumed(Assumption::kHeights, f.id.osm);
  }
  for (map::Footprint& f : footprints) {
    const auto outline = follows_outline(f) ? outlines.find(*f.outline) : outlines.end();
    if (outline != outlines.end()) set_as_outline(*outline->second, f);
  }
  return footprints;
}

}  // namespace citykiln::assume
