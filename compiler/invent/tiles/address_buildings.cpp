#include "compiler/invent/tiles/address_buildings.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/tags.h"

namespace citykiln::invent {
namespace {

constexpr double kFarthestStreet_m = 40;

bool has_address(std::string_view building) {
  return !building.empty() && building != "garage" && building != "garages" && building != "shed" &&
         building != "roof" && building != "barn" && building != "kiosk";
}

/// A building's place on a street.
struct StreetPlace {
  std::uint32_t line = 0;
  bool is_left = false;
  double along_m = 0;
  std::uint32_t area = 0;
  auto operator<=>(const StreetPlace&) const = default;
};

class Streets {
 public:
  explicit Streets(const InventedMap& map) : map_(map) {
    for (std::uint32_t i = 0; i < map.lines.size(); ++i)
      if (!value_in(map.lines[i].tags, "name").empty() && !value_in(map.lines[i].tags, "highway").empty())
        add_street(i);
    grid_ = grid_of(boxes_, kFarthestStreet_m);
  }

  std::optional<StreetPlace> nearest(Vec2 p) const {
    double least_m = kFarthestStreet_m;
    std::optional<StreetPlace> found;
    const Box2 about = Box2{p, p}.widened(kFarthestStreet_m);
    for (const std::uint32_t k : boxes_about(grid_, about)) {
      const Polyline& axis = map_.lines[segments_[k].line].axis;
      const Vec2 a = axis[segments_[k].segment], b = axis[segments_[k].segment + 1];
      const double away_m = distance_to_segment(a, b, p);
      if (away_m >= least_m) continue;
      least_m = away_m;
      found = {segments_[k].line, twice_area(a, b, p) > 0,
               segments_[k].begin_m + nearest_share(a, b, p) * distance(a, b), 0};
    }
    return found;
  }

 private:
  struct Segment {
    std::uint32_t line, segment;
    double begin_m;
  };

  void add_street(std::uint32_t line) {
    const Polyline& axis = map_.lines[line].axis;
    double begin_m = 0;
    for (std::uint32_t i = 0; i + 1 < axis.size(); ++i) {
      segments_.push_back({line, i, begin_m});
      boxes_.push_back(box_of(std::span(axis).subspan(i, 2)));
      begin_m += distance(axis[i], axis[i + 1]);
    }
  }

  const InventedMap& map_;
  std::vector<Segment> segments_;
  std::vector<Box2> boxes_;
  BoxGrid grid_;
};

std::vector<StreetPlace> places_of_buildings(const InventedMap& map) {
  const Streets streets(map);
  std::vector<StreetPlace> places;
  for (std::uint32_t i = 0; i < map.areas.size(); ++i) {
    if (!has_address(value_in(map.areas[i].tags, "building"))) continue;
    std::optional<StreetPlace> place = streets.nearest(box_of(map.areas[i].polygon.outer).centre());
    if (!place) continue;
    place->area = i;
    places.push_back(*place);
  }
  std::ranges::sort(places);
  return places;
}

}  // namespace

void address_buildings(InventedMap& map) {
  std::uint32_t line = 0;
  int left = 0, right = 0;
  for (const StreetPlace& place : places_of_buildings(map)) {
    if (place.line != line) line = place.line, left = right = 0;
    const int number = place.is_left ? 1 + 2 * left++ : 2 + 2 * right++;
    Tags& tags = map.areas[place.area].tags;
    tags.emplace_back("addr:housenumber", std::to_string(number));
    tags.emplace_back("addr:street", value_in(map.lines[place.line].tags, "name"));
    std::ranges::sort(tags);
  }
}

}  // namespace citykiln::invent
