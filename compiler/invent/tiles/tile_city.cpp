#include "compiler/invent/tiles/tile_city.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/box_grid.h"
#include "compiler/geometry/segment.h"
#include "compiler/invent/land/noise.h"
#include "compiler/invent/tags.h"
#include "compiler/invent/tiles/join_covers.h"
#include "compiler/invent/tiles/join_lines.h"

namespace citykiln::invent {
namespace {

constexpr double kFarthestStreet_m = 40;

bool has_address(std::string_view building) {
  return !building.empty() && building != "garage" && building != "garages" && building != "shed" &&
         building != "roof" && building != "barn" && building != "kiosk";
}

// A building's place on a street.
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

// Gives each building that is not an outbuilding the name of the nearest named street within 40 m, and a number: odd
// on the street's left, even on its right, rising along it. O(buildings + street segments).
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

constexpr std::array kStems = {
    "Ahorn",  "Birken",   "Buchen", "Eichen",    "Erlen",   "Eschen",  "Linden",  "Ulmen",   "Wiesen",  "Garten",
    "Mühl",   "Berg",     "Tal",    "Brunnen",   "Kirsch",  "Apfel",   "Rosen",   "Feld",    "Wald",    "Bach",
    "Stein",  "Sand",     "Weiden", "Kastanien", "Amsel",   "Drossel", "Finken",  "Lerchen", "Meisen",  "Schwalben",
    "Falken", "Storchen", "Hasel",  "Holunder",  "Ginster", "Tannen",  "Fichten", "Kiefern", "Lärchen", "Pappel"};

constexpr std::array kSmall = {"weg", "gasse", "steig", "winkel", "ring"};
constexpr std::array kMain = {"straße", "allee", "damm", "chaussee", "promenade"};

// Returns a name for the `number`-th street of a world; names of 200 numbers in turn differ. Main streets have other
// names than small ones.
std::string street_name(std::uint32_t number, bool is_main, std::uint64_t seed) {
  // a walk through all pairs of stem and ending, begun at a place that the seed draws
  constexpr std::uint32_t kPairs = kStems.size() * kSmall.size();
  const std::uint32_t first = RandomSequence(seed, {}, "street names").below(kPairs, 0);
  // 77 has no divisor in common with the 200 pairs
  const std::uint32_t pair = (first + number * 77) % kPairs;
  const std::string stem = kStems[pair % kStems.size()];
  const std::uint32_t ending = pair / kStems.size();
  return stem + (is_main ? kMain[ending] : kSmall[ending]);
}

/// Turns a place of the unit square counter-clockwise.
Vec2 turned(Vec2 p, int turns) {
  for (int i = 0; i < turns; ++i) p = {1 - p.y, p.x};
  return p;
}

/// Places on a grid of 1 cm, so that neighbouring cells have equal points on their common side.
double on_grid(double v) { return std::floor(v * 100 + 0.5) / 100; }

class TileCity {
 public:
  TileCity(const TileSet& set, const TileGrid& grid, std::uint64_t seed, InventedMap& map)
      : set_(set), grid_(grid), seed_(seed), map_(map) {}

  void add() {
    covers_.assign(grid_.tiles.size(), 0);
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column) add_cell(column, row);
    add_covers();
    std::vector<InventedLine> joined = join_lines(lines_, map_.points);
    name_streets(joined);
    map_.lines.insert(map_.lines.end(), std::make_move_iterator(joined.begin()), std::make_move_iterator(joined.end()));
    address_buildings(map_);
  }

 private:
  Vec2 place(int column, int row, Vec2 in_cell) const {
    return {on_grid((column + in_cell.x - grid_.columns / 2.0) * set_.cell_m),
            on_grid((row + in_cell.y - grid_.rows / 2.0) * set_.cell_m)};
  }

  Tags tags_of(const TileContent& content, int column, int row, std::size_t number) const {
    Tags tags;
    for (std::size_t i = 0; i < content.tags.size(); ++i) {
      const TagChoice& choice = content.tags[i];
      const std::uint64_t hash = hash_of(column, row, seed_ + number * 64 + i);
      const std::string& value = choice.values[(hash >> 16) % choice.values.size()];
      // "-" leaves the tag out
      if (value != "-") tags.emplace_back(choice.key, value);
    }
    return tags;
  }

  void add_cell(int column, int row) {
    const TurnedTile& turned_tile = set_.turned[grid_.at(column, row)];
    const Tile& tile = set_.tiles[turned_tile.tile];
    for (std::size_t i = 0; i < tile.content.size(); ++i) {
      const TileContent& content = tile.content[i];
      Tags tags = tags_of(content, column, row, i);
      Polyline points;
      for (const Vec2 p : content.points) points.push_back(place(column, row, turned(p, turned_tile.turn)));
      if (content.kind == ContentKind::kLine)
        lines_.push_back({std::move(points), std::move(tags)});
      else if (content.kind == ContentKind::kArea)
        map_.areas.push_back({{std::move(points), {}}, std::move(tags)});
      else if (content.kind == ContentKind::kPoint)
        map_.points.push_back({points.front(), std::move(tags)});
      else if (content.kind == ContentKind::kCover)
        covers_[static_cast<std::size_t>(row) * grid_.columns + column] =
            labels_.try_emplace(std::move(tags), static_cast<std::uint32_t>(labels_.size() + 1)).first->second;
    }
  }

  void add_covers() {
    const auto joined = join_covers(covers_, grid_.columns, static_cast<std::uint32_t>(labels_.size() + 1));
    for (const auto& [tags, label] : labels_)
      for (Polygon polygon : joined[label]) {
        for (Vec2& p : polygon.outer) p = place(0, 0, p);
        for (Ring& hole : polygon.holes)
          for (Vec2& p : hole) p = place(0, 0, p);
        map_.areas.push_back({std::move(polygon), tags});
      }
  }

  void name_streets(std::vector<InventedLine>& lines) const {
    std::uint32_t number = 0;
    for (InventedLine& line : lines) {
      const std::string_view road = value_in(line.tags, "highway");
      const bool is_main = road == "primary" || road == "secondary" || road == "tertiary";
      if (!is_main && road != "residential" && road != "living_street" && road != "pedestrian") continue;
      line.tags.emplace_back("name", street_name(number++, is_main, seed_));
      std::ranges::sort(line.tags);
    }
  }

  const TileSet& set_;
  const TileGrid& grid_;
  std::uint64_t seed_;
  InventedMap& map_;
  std::vector<InventedLine> lines_;
  std::vector<std::uint32_t> covers_;
  std::map<Tags, std::uint32_t> labels_;
};

}  // namespace

void add_tile_city(const TileSet& set, const TileGrid& grid, std::uint64_t seed, InventedMap& map) {
  TileCity(set, grid, seed, map).add();
}

}  // namespace citykiln::invent
