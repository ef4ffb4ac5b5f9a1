#include "compiler/invent/town/blocks/town_lots.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/line_part.h"
#include "compiler/geometry/polygons/clip_polyline.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/segment.h"
#include "compiler/geometry/snap.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/railway.h"
#include "compiler/invent/town/streets/street_sections.h"
#include "compiler/parcels/divide.h"

namespace citykiln::invent {
namespace {

/// Usual sizes of lots, by block use: area, front, depth.
constexpr std::array<parcels::LotSize, 8> kLotSizes = {{{420, 17, 27},
                                                        {380, 10, 34},
                                                        {720, 19, 36},
                                                        {1150, 26, 46},
                                                        {2600, 46, 52},
                                                        {1300, 30, 44},
                                                        {5200, 64, 64},
                                                        {1500, 32, 50}}};

const char* landuse_of(BlockUse use) {
  switch (use) {
    case BlockUse::kCommerce:
      return "commercial";
    case BlockUse::kIndustry:
      return "industrial";
    case BlockUse::kFarms:
      return "farmyard";
    default:
      return "residential";
  }
}

BlockUse side_use(const TownPlan& plan, const std::vector<TownBlock>& blocks, std::uint32_t block, Vec2 p) {
  const bool is_known = block != kNoBlock && !blocks[block].ring.empty() && has_lots(blocks[block].use);
  return is_known && blocks[block].area_m2 < 4e5 ? blocks[block].use : use_at(plan, p);
}

class Division {
 public:
  Division(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
           const std::vector<TownBlock>& blocks)
      : plan_(plan), graph_(graph), edges_(edges), blocks_(blocks) {}

  TownLots run() {
    prepare();
    const parcels::Parcels parcels = parcels::divide(land_, 0);
    index_fronts();
    TownLots lots;
    std::vector<std::array<double, 8>> uses(parcels.blocks.size());
    for (const parcels::Lot& lot : parcels.lots)
      if (std::optional<TownLot> town_lot = lot_of(lot)) {
        uses[lot.block][static_cast<std::size_t>(town_lot->use)] += area_m2(lot.polygon);
        lots.lots.push_back(std::move(*town_lot));
      }
    for (std::size_t i = 0; i < uses.size(); ++i) add_land(parcels.blocks[i], uses[i], lots.land);
    return lots;
  }

 private:
  // ---- the land that is divided

  void prepare() {
    const double half = plan_.half_m();
    land_.extent = {{-half, -half}, {half, half}};
    land_.sizes.assign(kLotSizes.begin(), kLotSizes.end());
    land_.split_empty = true;
    for (std::uint32_t i = 0; i < edges_.size(); ++i) land_.lines.push_back(line_of(i));
    for (const TownBlock& block : blocks_)
      if (!has_lots(block.use)) land_.taken.push_back({block.ring, {}});
    add_water();
    add_tracks();
  }

  void add_tracks() {
    const Railway& railway = plan_.railway;
    if (railway.axis.size() < 2) return;
    land_.lines.push_back({stable_id(StableId{0}, "track", 0), railway.axis, kTrackHalf_m, kTrackHalf_m,
                           parcels::LineKind::kBarrier, 0, 0});
    if (railway.has_station)
      land_.taken.push_back(
          {counter_clockwise({on_place_grid(railway.at(-100, -16)), on_place_grid(railway.at(100, -16)),
                              on_place_grid(railway.at(100, 36)), on_place_grid(railway.at(-100, 36))}),
           {}});
  }

  static Ring counter_clockwise(Ring ring) {
    if (signed_area_m2(ring) < 0) std::ranges::reverse(ring);
    return ring;
  }

  parcels::Line line_of(std::uint32_t i) const {
    const StreetEdge& edge = edges_[i];
    const double half_m = street_section(plan_, edge, graph_.streets[edge.street].street_class).half_m();
    const Vec2 middle = edge.axis[edge.axis.size() / 2];
    const BlockUse left = side_use(plan_, blocks_, edge.left_block, middle);
    const BlockUse right = side_use(plan_, blocks_, edge.right_block, middle);
    const bool has_fronts = plan_.density.at(middle) > kTownEdge;
    return {stable_id(StableId{0}, "edge", i),
            edge.axis,
            half_m,
            half_m,
            edge.is_bridge || !has_fronts ? parcels::LineKind::kBarrier : parcels::LineKind::kStreet,
            static_cast<std::uint8_t>(left),
            static_cast<std::uint8_t>(right)};
  }

  void add_water() {
    const Terrain& terrain = *plan_.terrain;
    for (const Polygon& lake : terrain.lakes) land_.taken.push_back(lake);
    for (const Polygon& sea : terrain.sea) land_.taken.push_back(sea);
    std::uint64_t number = 0;
    for (const River& river : terrain.rivers) {
      const double half_m = *std::ranges::max_element(river.width_m) / 2 + 3;
      Polyline axis;
      for (const Vec2 p : river.axis) axis.push_back(on_place_grid(p));
      for (const Polyline& part : clipped_to(axis, land_.extent, kPlaceStep_m))
        land_.lines.push_back(
            {stable_id(StableId{0}, "river", number++), part, half_m, half_m, parcels::LineKind::kBarrier, 0, 0});
    }
  }

  // ---- lots of its parcels

  void index_fronts() {
    std::vector<Box2> boxes;
    for (std::uint32_t i = 0; i < edges_.size(); ++i)
      for (std::size_t k = 0; k + 1 < edges_[i].axis.size(); ++k) {
        Box2 box;
        box.grow(edges_[i].axis[k]);
        box.grow(edges_[i].axis[k + 1]);
        boxes.push_back(box.widened(land_.lines[i].left_m + 0.5));
        reaches_.push_back({i, k});
      }
    reach_grid_ = grid_of(boxes, 32);
  }

  // the street edge on whose border a place lies, the number of edges if none
  std::uint32_t street_at(Vec2 p) const {
    for (const std::uint32_t r : boxes_about(reach_grid_, p)) {
      const auto& [edge, k] = reaches_[r];
      if (land_.lines[edge].kind != parcels::LineKind::kStreet) continue;
      const double away_m = distance_to_segment(edges_[edge].axis[k], edges_[edge].axis[k + 1], p);
      if (std::abs(away_m - land_.lines[edge].left_m) < 0.3) return edge;
    }
    return static_cast<std::uint32_t>(edges_.size());
  }

  std::optional<TownLot> lot_of(const parcels::Lot& lot) const {
    if (lot.frontage.line >= edges_.size() || lot.polygon.outer.size() < 3 || !lot.polygon.holes.empty())
      return std::nullopt;
    TownLot town_lot;
    town_lot.ring = lot.polygon.outer;
    town_lot.edge = lot.frontage.line;
    town_lot.is_on_left = lot.frontage.side == parcels::Side::kLeft;
    town_lot.use = static_cast<BlockUse>(town_lot.is_on_left ? land_.lines[lot.frontage.line].left_size
                                                             : land_.lines[lot.frontage.line].right_size);
    if (!find_front(town_lot)) return std::nullopt;
    const StreetEdge& edge = edges_[town_lot.edge];
    town_lot.at_m =
        distances_on(edge.axis)[lot.frontage.from.segment] + (lot.frontage.from.at_m + lot.frontage.to.at_m) / 2;
    town_lot.density = plan_.density.at((town_lot.from + town_lot.to) * 0.5);
    if (town_lot.density <= kTownEdge || is_wet(town_lot.ring)) return std::nullopt;
    return town_lot;
  }

  bool is_wet(const Ring& ring) const {
    return std::ranges::any_of(ring, [&](Vec2 p) { return plan_.water.may_be_water(p); });
  }

  // marks the edges on streets, and takes the longest run of those on the lot's own street as its front
  bool find_front(TownLot& lot) const {
    const std::size_t n = lot.ring.size();
    std::vector<std::uint32_t> street(n);
    for (std::size_t i = 0; i < n; ++i) street[i] = street_at((lot.ring[i] + lot.ring[(i + 1) % n]) * 0.5);
    for (std::size_t i = 0; i < n; ++i) lot.is_on_street.push_back(street[i] < edges_.size());
    double longest_m = 0;
    for (std::size_t first = 0; first < n; ++first) {
      if (street[first] != lot.edge || street[(first + n - 1) % n] == lot.edge) continue;
      std::size_t end = first;
      while (street[end % n] == lot.edge && end < first + n) ++end;
      const Vec2 a = lot.ring[first], b = lot.ring[end % n];
      if (distance(a, b) <= longest_m) continue;
      longest_m = distance(a, b);
      lot.from = a;
      lot.to = b;
    }
    return longest_m > 3;
  }

  // ---- land use

  static Polygon on_grid(const Polygon& polygon) {
    Polygon snapped;
    const auto snap = [](const Ring& ring) {
      Ring points;
      for (const Vec2 p : ring) points.push_back(on_place_grid(p));
      return without_repeats(points);
    };
    snapped.outer = snap(polygon.outer);
    for (const Ring& hole : polygon.holes)
      if (Ring ring = snap(hole); ring.size() >= 3) snapped.holes.push_back(std::move(ring));
    return snapped;
  }

  void add_land(const parcels::Block& block, const std::array<double, 8>& uses, std::vector<InventedArea>& land) const {
    const double whole_m2 = area_m2(block.polygon);
    double built_m2 = 0;
    for (const double use : uses) built_m2 += use;
    if (built_m2 < 0.55 * whole_m2 || whole_m2 > 2e5) return;
    const auto use = static_cast<BlockUse>(std::ranges::max_element(uses) - uses.begin());
    const bool is_centre = use == BlockUse::kCore && plan_.density.at(block.polygon.outer[0]) > 0.8;
    Polygon polygon = on_grid(block.polygon);
    if (polygon.outer.size() < 400 && !is_simple(polygon.outer)) return;
    land.push_back({std::move(polygon), tags_of({{"landuse", is_centre ? "retail" : landuse_of(use)}})});
  }

  const TownPlan& plan_;
  const StreetGraph& graph_;
  const std::vector<StreetEdge>& edges_;
  const std::vector<TownBlock>& blocks_;
  parcels::Land land_;
  std::vector<std::pair<std::uint32_t, std::size_t>> reaches_;
  BoxGrid reach_grid_;
};

}  // namespace

TownLots divide_town(const TownPlan& plan, const StreetGraph& graph, const std::vector<StreetEdge>& edges,
                     const std::vector<TownBlock>& blocks) {
  return Division(plan, graph, edges, blocks).run();
}

}  // namespace citykiln::invent
