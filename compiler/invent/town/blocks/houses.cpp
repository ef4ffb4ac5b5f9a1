#include "compiler/invent/town/blocks/houses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "compiler/geometry/polygons/centroid.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/blocks/footprints.h"
#include "compiler/invent/town/blocks/house_tags.h"

namespace citykiln::invent {
namespace {

// Where an edge lies on its street.
struct EdgePlace {
  double from_m = 0;
  bool is_reversed = false;
};

using EdgesAtVertex = std::map<std::uint32_t, std::vector<std::uint32_t>>;

// the edge from which to walk along a street: one at an end, else the first
std::pair<std::uint32_t, std::uint32_t> first_edge(const std::vector<StreetEdge>& edges,
                                                   const std::vector<std::uint32_t>& left, const EdgesAtVertex& at) {
  for (const std::uint32_t e : left)
    for (const std::uint32_t v : {edges[e].vertices.front(), edges[e].vertices.back()})
      if (at.at(v).size() == 1) return {e, v};
  return {left.front(), edges[left.front()].vertices.front()};
}

// walks along the edges of one street and notes where each begins
void place_street(const std::vector<StreetEdge>& edges, std::vector<std::uint32_t> left,
                  std::vector<EdgePlace>& places) {
  double at_m = 0;
  while (!left.empty()) {
    EdgesAtVertex at;
    for (const std::uint32_t e : left)
      for (const std::uint32_t v : {edges[e].vertices.front(), edges[e].vertices.back()}) at[v].push_back(e);
    auto [edge, vertex] = first_edge(edges, left, at);
    for (bool goes_on = true; goes_on;) {
      places[edge] = {at_m, edges[edge].vertices.front() != vertex};
      at_m += length_m(edges[edge].axis);
      vertex = places[edge].is_reversed ? edges[edge].vertices.front() : edges[edge].vertices.back();
      std::erase(left, edge);
      const auto next =
          std::ranges::find_if(at[vertex], [&](std::uint32_t e) { return std::ranges::find(left, e) != left.end(); });
      goes_on = next != at[vertex].end();
      if (goes_on) edge = *next;
    }
  }
}

// Returns a number for each lot; numbers of a street grow along it. O(n log n).
std::vector<int> house_numbers(const std::vector<StreetEdge>& edges, const std::vector<TownLot>& lots) {
  std::map<std::uint32_t, std::vector<std::uint32_t>> streets;
  for (std::uint32_t i = 0; i < edges.size(); ++i) streets[edges[i].street].push_back(i);
  std::vector<EdgePlace> places(edges.size());
  for (const auto& [street, of_street] : streets) place_street(edges, of_street, places);
  std::vector<std::tuple<std::uint32_t, bool, double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < lots.size(); ++i) {
    const TownLot& lot = lots[i];
    const EdgePlace& place = places[lot.edge];
    const double along_m = place.is_reversed ? length_m(edges[lot.edge].axis) - lot.at_m : lot.at_m;
    order.push_back({edges[lot.edge].street, lot.is_on_left != place.is_reversed, place.from_m + along_m, i});
  }
  std::ranges::sort(order);
  std::vector<int> numbers(lots.size());
  for (std::size_t k = 0, count = 0; k < order.size(); ++k, ++count) {
    const auto& [street, is_left, at_m, lot] = order[k];
    if (k > 0 && (std::get<0>(order[k - 1]) != street || std::get<1>(order[k - 1]) != is_left)) count = 0;
    numbers[lot] = static_cast<int>(2 * count) + (is_left ? 1 : 2);
  }
  return numbers;
}

/// From the front of a terrace to its rear.
constexpr double kTerraceDepth_m = 11;

constexpr std::array kShops = {"bakery",      "butcher", "clothes",     "books",       "florist",
                               "hairdresser", "shoes",   "convenience", "optician",    "bicycle",
                               "gift",        "jewelry", "electronics", "greengrocer", "chemist"};
constexpr std::array kServices = {"cafe", "restaurant", "pub", "bank", "pharmacy", "bar", "fast_food", "post_office"};

/// The lot that is built on, and what is known of it.
class LotBuilder {
 public:
  LotBuilder(const TownPlan& plan, const TownLot& lot, std::size_t number, std::string street, int house_number,
             InventedMap& map)
      : plan_(plan),
        lot_(lot),
        street_(std::move(street)),
        house_number_(house_number),
        map_(map),
        draws_(plan.settings.seed, "lot", number) {}

  void build() {
    switch (lot_.use) {
      case BlockUse::kCore:
        return build_core();
      case BlockUse::kTerraces:
        return build_terrace();
      case BlockUse::kFlats:
        return build_flats();
      case BlockUse::kCommerce:
        return build_large(0.75, 26, 5);
      case BlockUse::kIndustry:
        return build_large(0.72, 42, 8);
      case BlockUse::kFarms:
        return build_farm();
      default:
        return build_house();
    }
  }

 private:
  bool is_corner() const {
    double fronts_m = 0;
    for (std::size_t i = 0; i < lot_.ring.size(); ++i)
      if (lot_.is_on_street[i]) fronts_m += distance(lot_.ring[i], lot_.ring[(i + 1) % lot_.ring.size()]);
    return fronts_m > lot_.frontage_m() + 8;
  }

  double lot_m2() const { return signed_area_m2(lot_.ring); }

  bool may_stand(const Ring& ring) const {
    return ring.size() >= 3 && std::ranges::none_of(ring, [&](Vec2 p) { return plan_.water.may_be_water(p); });
  }

  void address(Tags& tags, const std::string& letter = "") const {
    set_tag(tags, "addr:street", street_);
    set_tag(tags, "addr:housenumber", std::to_string(house_number_) + letter);
  }

  void add_main(const Ring& ring, Tags tags, const std::string& letter = "") {
    address(tags, letter);
    add_building(ring, std::move(tags));
  }

  void add_building(const Ring& ring, Tags tags) {
    if (!may_stand(ring)) return;
    built_.push_back(ring);
    map_.areas.push_back({{ring, {}}, std::move(tags)});
  }

  // ---- rows

  void build_core() {
    const double depth_m = draws_.between(11, 14);
    Ring ring = row_ring(lot_, 0, depth_m);
    // what would remain behind the house is no court: the house takes the whole lot
    if (!ring.empty() && lot_m2() - signed_area_m2(ring) < 35 && lot_m2() < 420 && is_simple(lot_.ring))
      ring = whole_lot();
    if (ring.empty()) return build_house();
    const int storeys = storeys_at(plan_, lot_.density, lot_.use, draws_);
    Tags tags = house_tags(lot_.use, storeys, is_corner(), draws_);
    turn_roof(tags, depth_m);
    add_main(ring, std::move(tags));
    if (lot_.density > 0.6 && draws_.chance(lot_.density - 0.2)) add_shop(ring);
    if (draws_.chance(0.22)) add_back_house();
  }

  Ring whole_lot() const {
    Ring ring;
    for (const Vec2 p : lot_.ring) ring.push_back(on_place_grid(p));
    ring = without_repeats(ring);
    return is_simple(ring) ? ring : Ring{};
  }

  // a lower house in the courtyard
  void add_back_house() {
    const HouseBox box{lot_.frontage_m() * 0.6, 8, 19, 0};
    if (const auto ring = fitted_box(lot_, box, 1); ring && is_apart(*ring, 4))
      add_building(*ring, outhouse_tags("shed", draws_));
  }

  // a ridge runs along the street, also on houses that are deeper than wide
  void turn_roof(Tags& tags, double depth_m) const {
    if (!is_corner()) set_tag(tags, "roof:orientation", lot_.frontage_m() < depth_m ? "across" : "along");
  }

  void build_terrace() {
    const Ring ring = row_ring(lot_, 3.5, kTerraceDepth_m);
    if (ring.empty() || lot_.frontage_m() > 16) return build_house();
    const int storeys = storeys_at(plan_, lot_.density, lot_.use, draws_);
    Tags tags = house_tags(lot_.use, storeys, is_corner(), draws_);
    turn_roof(tags, kTerraceDepth_m);
    add_main(ring, std::move(tags));
    if (draws_.chance(0.3)) add_shed();
  }

  // ---- houses that stand free

  void build_house() {
    if (lot_.frontage_m() > 17.5 && lot_.use == BlockUse::kHouses && draws_.chance(0.3)) return build_pair();
    const bool is_villa = lot_.use == BlockUse::kVillas;
    const double width_m =
        std::min(lot_.frontage_m() - 5, is_villa ? draws_.between(12, 17) : draws_.between(10, 14.5));
    if (width_m < 5) return;
    HouseBox box{width_m, is_villa ? draws_.between(11, 14) : draws_.between(9.5, 12.5), draws_.between(3.5, 7), 0};
    box.aside_m = draws_.chance(0.5) ? 1.8 : -1.8;
    const auto ring = fitted_box(lot_, box, 1.6);
    if (!ring) return;
    add_main(*ring, house_tags(lot_.use, storeys_at(plan_, lot_.density, lot_.use, draws_), false, draws_));
    if (draws_.chance(0.5)) add_garage(box.aside_m);
    if (draws_.chance(0.3)) add_shed();
    add_garden_tree();
  }

  // two houses that share a wall
  void build_pair() {
    const double width_m = std::min(8.5, (lot_.frontage_m() - 5) / 2), setback_m = draws_.between(4, 6);
    const HouseBox left{width_m, 11, setback_m, -width_m / 2}, right{width_m, 11, setback_m, width_m / 2};
    const Ring a = box_ring(lot_, left), b = box_ring(lot_, right);
    if (!lies_within(a, lot_.ring, 1.5) || !lies_within(b, lot_.ring, 1.5)) return;
    Tags tags = house_tags(BlockUse::kHouses, 2, false, draws_);
    set_tag(tags, "building", "semidetached_house");
    set_tag(tags, "roof:shape", "gabled");
    set_tag(tags, "roof:orientation", "along");
    add_main(a, tags, "a");
    add_main(b, tags, "b");
  }

  void add_garage(double aside_m) {
    const double side = aside_m > 0 ? -1 : 1;
    const HouseBox box{3.2, 6.2, draws_.between(5.5, 9), side * (lot_.frontage_m() / 2 - 2.4)};
    const Ring ring = box_ring(lot_, box);
    if (lies_within(ring, lot_.ring, 0.5) && is_apart(ring, 0.5)) add_building(ring, outhouse_tags("garage", draws_));
  }

  void add_shed() {
    const HouseBox box{draws_.between(2.5, 4), 2.6, draws_.between(22, 30),
                       draws_.between(-0.3, 0.3) * lot_.frontage_m()};
    const Ring ring = box_ring(lot_, box);
    if (lies_within(ring, lot_.ring, 0.6) && is_apart(ring, 3)) add_building(ring, outhouse_tags("shed", draws_));
  }

  bool is_apart(const Ring& ring, double by_m) const {
    return std::ranges::all_of(built_, [&](const Ring& other) {
      if (borders_touch(ring, other)) return false;
      const auto is_free = [&](const Ring& a, const Ring& b) {
        return std::ranges::all_of(
            a, [&](Vec2 p) { return winding_number(b, p) == 0 && distance_to_polyline(closed(b), p) >= by_m; });
      };
      return is_free(ring, other) && is_free(other, ring);
    });
  }

  static Polyline closed(const Ring& ring) {
    Polyline line = ring;
    line.push_back(ring.front());
    return line;
  }

  void add_garden_tree() {
    if (!draws_.chance(0.3)) return;
    const Vec2 p = (lot_.from + lot_.to) * 0.5 + lot_.inward() * draws_.between(19, 27) +
                   lot_.along() * (draws_.between(-0.35, 0.35) * lot_.frontage_m());
    const Ring about = {p + Vec2{-2, -2}, p + Vec2{2, -2}, p + Vec2{2, 2}, p + Vec2{-2, 2}};
    if (lies_within(about, lot_.ring, 0.5) && is_apart(about, 1))
      map_.points.push_back({on_place_grid(p), tags_of({{"natural", "tree"}, {"leaf_type", "broadleaved"}})});
  }

  // ---- large buildings

  void build_flats() {
    const int storeys = storeys_at(plan_, lot_.density, lot_.use, draws_);
    const double width_m =
        storeys > 7 ? draws_.between(19, 24) : std::min(lot_.frontage_m() - 7, draws_.between(28, 58));
    const HouseBox box{width_m, storeys > 7 ? 20 : draws_.between(11, 13.5), draws_.between(6, 10), 0};
    const auto ring = width_m < 12 ? std::nullopt : fitted_box(lot_, box, 3);
    if (!ring) return build_house();
    add_main(*ring, house_tags(lot_.use, storeys, false, draws_));
    add_garden_tree();
  }

  void build_large(double share, double depth_m, double setback_m) {
    const HouseBox box{lot_.frontage_m() * share, depth_m * draws_.between(0.6, 1), setback_m, 0};
    auto ring = fitted_box(lot_, box, 3);
    if (!ring) ring = fitted_box(lot_, {box.width_m * 0.8, box.depth_m * 0.5, setback_m * 0.7, 0}, 2.5);
    if (!ring) return;
    add_main(*ring, house_tags(lot_.use, storeys_at(plan_, lot_.density, lot_.use, draws_), false, draws_));
  }

  void build_farm() {
    build_house();
    if (built_.empty() || !draws_.chance(0.75)) return;
    for (const double setback_m : {20.0, 24.0, 17.0}) {
      const HouseBox box{draws_.between(14, 24), draws_.between(9, 12), setback_m, draws_.between(-3, 3)};
      const auto ring = fitted_box(lot_, box, 1.5);
      if (!ring || !is_apart(*ring, 3)) continue;
      return add_building(*ring, outhouse_tags("barn", draws_));
    }
  }

  // ---- shops

  // a point in the house behind its front
  void add_shop(const Ring& ring) {
    const Vec2 p = on_place_grid((lot_.from + lot_.to) * 0.5 + lot_.inward() * 2.5);
    if (winding_number(ring, p) == 0) return;
    const bool is_shop = draws_.chance(0.65);
    Tags tags = is_shop ? tags_of({{"shop", kShops[draws_.below(kShops.size())]}})
                        : tags_of({{"amenity", kServices[draws_.below(kServices.size())]}});
    address(tags);
    map_.points.push_back({p, std::move(tags)});
  }

  const TownPlan& plan_;
  const TownLot& lot_;
  std::string street_;
  int house_number_;
  InventedMap& map_;
  Draws draws_;
  std::vector<Ring> built_;
};

}  // namespace

void add_houses(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                const std::vector<TownLot>& lots, InventedMap& map) {
  const std::vector<int> numbers = house_numbers(edges, lots);
  for (std::size_t i = 0; i < lots.size(); ++i)
    LotBuilder(plan, lots[i], i, graph.streets[edges[lots[i].edge].street].name, numbers[i], map).build();
}

}  // namespace citykiln::invent
