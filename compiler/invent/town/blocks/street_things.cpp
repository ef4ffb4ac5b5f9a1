#include "compiler/invent/town/blocks/street_things.h"

#include <algorithm>
#include <array>

#include "compiler/geometry/line_part.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/town/draws.h"
#include "compiler/invent/town/streets/street_sections.h"

namespace citykiln::invent {
namespace {

/// Trees, lamps and stops keep this distance from the ends of an edge.
constexpr double kClearOfJunction_m = 17;
/// The least distance along an edge between its end and a crossing.
constexpr double kCrossingFromJunction_m = 10;
constexpr double kSignFromJunction_m = 8;

constexpr std::array kFurniture = {std::pair("amenity", "waste_basket"),    std::pair("amenity", "bench"),
                                   std::pair("man_made", "street_cabinet"), std::pair("amenity", "post_box"),
                                   std::pair("amenity", "bicycle_parking"), std::pair("emergency", "fire_hydrant"),
                                   std::pair("advertising", "column"),      std::pair("amenity", "vending_machine")};

class EdgeThings {
 public:
  EdgeThings(const TownPlan& plan, const StreetGraph& graph, StreetEdge& edge, std::size_t number, InventedMap& map)
      : plan_(plan),
        graph_(graph),
        edge_(edge),
        street_(graph.streets[edge.street]),
        map_(map),
        draws_(plan.settings.seed, "edge things", number),
        along_(distances_on(edge.axis)),
        section_(street_section(plan, edge, street_.street_class)),
        density_(plan.density.at(edge.axis[edge.axis.size() / 2])) {}

  void add() {
    if (edge_.is_bridge || street_.is_roundabout || density_ <= kTownEdge) return;
    const double whole_m = along_.back();
    const double lamp_step_m = is_main(street_.street_class) ? 28 : 34;
    add_beside(
        lamp_step_m, 0.5, [&](double) { return lamp_tags(); }, true);
    if (has_trees())
      add_beside(
          11, 1.0, [&](double) { return tree_tags(); }, false);
    if (is_main(street_.street_class) && whole_m > 130 && draws_.chance(whole_m / 420)) add_bus_stop();
    if (density_ > 0.25 && whole_m > 60) add_furniture();
    add_vertices();
  }

 private:
  bool has_trees() {
    if (street_.street_class <= StreetClass::kSecondary) return density_ > 0.1;
    return density_ > 0.3 && draws_.chance(street_.street_class == StreetClass::kTertiary ? 0.7 : 0.25);
  }

  Tags lamp_tags() const {
    Tags tags = tags_of(
        {{"highway", "street_lamp"}, {"lamp_mount", is_main(street_.street_class) ? "bent_mast" : "straight_mast"}});
    if (density_ > 0.6 && !is_main(street_.street_class)) set_tag(tags, "lamp_type", "led");
    return tags;
  }

  Tags tree_tags() const {
    return tags_of(
        {{"natural", "tree"}, {"leaf_type", "broadleaved"}, {"genus", density_ > 0.5 ? "Platanus" : "Tilia"}});
  }

  // things beside the carriageway every step_m: on both sides, or on alternate ones
  template <typename MakeTags>
  void add_beside(double step_m, double from_kerb_m, MakeTags make_tags, bool alternates) {
    if (section_.pavement_m <= 0) return;
    const double room_m = along_.back() - 2 * kClearOfJunction_m;
    if (room_m < 0) return;
    const int steps = static_cast<int>(room_m / step_m);
    for (int i = 0; i <= steps; ++i) {
      const double at_m =
          kClearOfJunction_m + (room_m - steps * step_m) / 2 + i * step_m + (alternates ? 0 : step_m / 3);
      if (at_m > along_.back() - kClearOfJunction_m) return;
      for (const int side : {1, -1})
        if (!alternates || (i % 2 == 0) == (side > 0)) add_point(at_m, side, from_kerb_m, make_tags(at_m));
    }
  }

  void add_point(double at_m, int side, double from_kerb_m, Tags tags) {
    const Vec2 p = point_at(edge_.axis, along_, at_m), ahead = unit(point_at(edge_.axis, along_, at_m + 0.5) - p);
    const Vec2 place =
        on_place_grid(p + left_of(ahead) * (side * (section_.carriageway_m / 2 + section_.parking_m + from_kerb_m)));
    if (!plan_.is_inside(place) || plan_.water.may_be_water(place)) return;
    map_.points.push_back({place, std::move(tags)});
  }

  void add_bus_stop() {
    const double at_m = along_.back() * draws_.between(0.4, 0.6);
    for (const int side : {1, -1}) {
      const double there_m = at_m + side * 12;
      add_point(there_m, side, 0.5,
                tags_of({{"highway", "bus_stop"},
                         {"public_transport", "platform"},
                         {"bus", "yes"},
                         {"name", street_.name},
                         {"shelter", "yes"},
                         {"bench", "yes"}}));
      add_point(there_m + 4, side, 1.3, tags_of({{"amenity", "shelter"}, {"shelter_type", "public_transport"}}));
      add_point(there_m + 7.5, side, 1.3, tags_of({{"amenity", "waste_basket"}}));
    }
  }

  void add_furniture() {
    const auto count = static_cast<int>(along_.back() * density_ / 70);
    for (int i = 0; i < count; ++i) {
      const auto& [key, value] = kFurniture[draws_.below(kFurniture.size())];
      const double at_m = draws_.between(kClearOfJunction_m, along_.back() - kClearOfJunction_m);
      add_point(at_m, draws_.chance(0.5) ? 1 : -1, 1.6, tags_of({{key, value}}));
    }
  }

  // ---- crossings and signs

  bool has_signals(std::uint32_t vertex) const {
    if (graph_.degree(vertex) < 3 || plan_.density.at(graph_.position(vertex)) < 0.3) return false;
    std::size_t large = 0;
    for (const std::uint32_t s : graph_.vertices()[vertex].segments) {
      if (graph_.street_of(s).is_roundabout) return false;
      large += graph_.street_of(s).street_class <= StreetClass::kTertiary;
    }
    return large >= 3;
  }

  bool meets_larger(std::uint32_t vertex) const {
    return std::ranges::any_of(graph_.vertices()[vertex].segments, [&](std::uint32_t s) {
      return graph_.street_of(s).street_class < street_.street_class || graph_.street_of(s).is_roundabout;
    });
  }

  void add_vertices() {
    const bool is_signalled[2] = {has_signals(edge_.vertices.front()), has_signals(edge_.vertices.back())};
    std::vector<std::pair<double, Tags>> added;
    for (const int end : {0, 1}) {
      const std::uint32_t vertex = end == 0 ? edge_.vertices.front() : edge_.vertices.back();
      if (graph_.degree(vertex) == 1 && street_.street_class >= StreetClass::kResidential &&
          plan_.is_inside(graph_.position(vertex) * 1.001))
        map_.points.push_back({graph_.position(vertex), tags_of({{"highway", "turning_circle"}})});
      if (graph_.degree(vertex) < 3 || along_.back() < 55) continue;
      if (std::optional<Tags> tags = tags_at_end(vertex, end, is_signalled[end])) {
        const double from_m = tags->front().second == "give_way" ? kSignFromJunction_m : kCrossingFromJunction_m;
        added.push_back({end == 0 ? from_m : along_.back() - from_m, std::move(*tags)});
      }
    }
    insert(added);
  }

  std::optional<Tags> tags_at_end(std::uint32_t vertex, int end, bool is_signalled) {
    if (is_signalled) {
      if (end == 0 || edge_.vertices.front() != vertex) mark_signals(vertex);
      return tags_of({{"crossing", "traffic_signals"}, {"highway", "crossing"}});
    }
    if (is_main(street_.street_class) && density_ > 0.2 && !meets_larger(vertex) && draws_.chance(0.35))
      return tags_of({{"crossing", "marked"}, {"crossing:markings", "zebra"}, {"highway", "crossing"}});
    if (meets_larger(vertex))
      return tags_of({{"direction", end == 0 ? "backward" : "forward"}, {"highway", "give_way"}});
    return std::nullopt;
  }

  // the junction's signals, once: by its first segment
  void mark_signals(std::uint32_t vertex) {
    const std::uint32_t first = graph_.vertices()[vertex].segments.front();
    const bool is_first = std::ranges::any_of(std::array{edge_.vertices[1], edge_.vertices[edge_.vertices.size() - 2]},
                                              [&](std::uint32_t v) { return graph_.other_end(first, vertex) == v; });
    if (is_first) map_.points.push_back({graph_.position(vertex), tags_of({{"highway", "traffic_signals"}})});
  }

  // puts vertices on the axis and points with their tags there
  void insert(const std::vector<std::pair<double, Tags>>& added) {
    Polyline axis;
    std::size_t next = 0;
    const auto put = [&] {
      axis.push_back(on_place_grid(point_at(edge_.axis, along_, added[next].first)));
      map_.points.push_back({axis.back(), added[next].second});
      ++next;
    };
    for (std::size_t i = 0; i < edge_.axis.size(); ++i) {
      while (next < added.size() && added[next].first < along_[i]) put();
      axis.push_back(edge_.axis[i]);
    }
    edge_.axis = std::move(axis);
  }

  const TownPlan& plan_;
  const StreetGraph& graph_;
  StreetEdge& edge_;
  const Street& street_;
  InventedMap& map_;
  Draws draws_;
  std::vector<double> along_;
  StreetSection section_;
  double density_;
};

}  // namespace

void add_street_things(const TownPlan& plan, const StreetGraph& graph, std::vector<StreetEdge>& edges,
                       InventedMap& map) {
  for (std::size_t i = 0; i < edges.size(); ++i) EdgeThings(plan, graph, edges[i], i, map).add();
}

}  // namespace citykiln::invent
