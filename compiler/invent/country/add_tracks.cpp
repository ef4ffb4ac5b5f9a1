#include "compiler/invent/country/add_tracks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <queue>

#include "compiler/contract/random_sequence.h"
#include "compiler/invent/country/taken_land.h"

namespace citykiln::invent {
namespace {

constexpr double kTrackStep_m = 16;
// a track costs twice as much on this slope, and four times on twice of it
constexpr double kDearSlope = 0.09;
// steeper tracks are footpaths
constexpr double kSteepestTrack = 0.2;
// an existing track costs so much of a new one
constexpr double kAlongTrack = 0.25;
// water costs as much as so many steps
constexpr double kFordCost = 12;
constexpr double kOffRoad_m = 4, kFarthest_m = 1600;

/// A grid of places that tracks can pass, and the edges that they use.
class TrackGrid {
 public:
  TrackGrid(const Terrain& terrain, const InventedMap& map, double side_m)
      : terrain_(terrain), count_(static_cast<int>(side_m / kTrackStep_m) + 1), side_m_(side_m) {
    TakenLand taken = taken_land_of(map, terrain, false);
    for (const InventedArea& area : map.areas)
      if (value_in(area.tags, "natural").empty() || value_in(area.tags, "natural") == "water") taken.add(area.polygon);
    for (const Polygon& sea : terrain.sea) taken.add(sea);
    taken.index();
    for (std::uint32_t i = 0; i < size(); ++i) {
      heights_m_.push_back(terrain.height_m(place(i)));
      is_blocked_.push_back(taken.distance_m(place(i), 2 * kTrackStep_m) < kOffRoad_m);
      is_wet_.push_back(terrain.is_water(place(i)));
    }
    places_.resize(size());
    for (std::uint32_t i = 0; i < size(); ++i) places_[i] = place(i);
    used_.assign(size(), 0);
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(count_) * static_cast<std::uint32_t>(count_); }
  bool is_blocked(std::uint32_t i) const { return is_blocked_[i]; }

  std::uint32_t nearest(Vec2 p) const {
    const auto cell = [&](double v) {
      return static_cast<std::uint32_t>(
          std::clamp(static_cast<int>((v + side_m_ / 2) / kTrackStep_m + 0.5), 0, count_ - 1));
    };
    return cell(p.y) * static_cast<std::uint32_t>(count_) + cell(p.x);
  }

  /// Joins the grid's point nearest to a vertex of a road to it. False if it is taken already.
  bool join_road(std::uint32_t i, Vec2 vertex) {
    if (used_[i] != 0) return false;
    is_blocked_[i] = false;
    places_[i] = vertex;
    return true;
  }

  /// Lays the cheapest track, if there is one. True if it was laid.
  bool lay(std::uint32_t from, std::uint32_t to) {
    const std::optional<std::vector<std::uint32_t>> path = cheapest(from, to);
    if (!path) return false;
    for (std::size_t k = 0; k + 1 < path->size(); ++k) use((*path)[k], (*path)[k + 1]);
    return true;
  }

  /// The lines between places where tracks meet or end.
  std::vector<Polyline> lines() {
    std::vector<Polyline> all;
    for (std::uint32_t i = 0; i < size(); ++i)
      if (is_end_[i])
        for (int d = 0; d < 8; ++d)
          if (used_[i] >> d & 1) all.push_back(line_from(i, d));
    for (std::uint32_t i = 0; i < size(); ++i)
      for (int d = 0; d < 8; ++d)
        if (used_[i] >> d & 1) all.push_back(line_from(i, d));
    return all;
  }

 private:
  static constexpr int kX[8] = {1, 1, 0, -1, -1, -1, 0, 1}, kY[8] = {0, 1, 1, 1, 0, -1, -1, -1};

  Vec2 place(std::uint32_t i) const {
    return {(i % count_) * kTrackStep_m - side_m_ / 2, (i / count_) * kTrackStep_m - side_m_ / 2};
  }
  int degree(std::uint32_t i) const { return std::popcount(used_[i]); }
  std::optional<std::uint32_t> neighbour(std::uint32_t i, int d) const {
    const int x = static_cast<int>(i % count_) + kX[d], y = static_cast<int>(i / count_) + kY[d];
    if (x < 0 || y < 0 || x >= count_ || y >= count_) return std::nullopt;
    return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(count_) + static_cast<std::uint32_t>(x);
  }

  void use(std::uint32_t a, std::uint32_t b) {
    for (int d = 0; d < 8; ++d)
      if (neighbour(a, d) == b) {
        used_[a] |= static_cast<std::uint8_t>(1 << d);
        used_[b] |= static_cast<std::uint8_t>(1 << ((d + 4) % 8));
      }
  }

  /// True if a diagonal step would cross a diagonal that is used.
  bool crosses_track(std::uint32_t i, int d) const {
    if (d % 2 == 0) return false;
    const auto beside = neighbour(i, (d + 7) % 8);
    return beside && (used_[*beside] >> ((d + 2) % 8) & 1) != 0;
  }

  double cost(std::uint32_t i, std::uint32_t j, int d) const {
    const double run_m = kTrackStep_m * (d % 2 == 1 ? 1.4142135623730951 : 1);
    const double slope = std::abs(heights_m_[i] - heights_m_[j]) / run_m / kDearSlope;
    const double water = is_wet_[i] != is_wet_[j] ? kFordCost * kTrackStep_m : is_wet_[j] ? 4 * run_m : 0;
    return (run_m * (1 + slope * slope) + water) * ((used_[i] >> d & 1) != 0 ? kAlongTrack : 1);
  }

  std::optional<std::vector<std::uint32_t>> cheapest(std::uint32_t from, std::uint32_t to) const {
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<double> costs(size(), 1e300);
    std::vector<std::uint32_t> before(size(), kNone);
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    costs[from] = 0;
    open.emplace(0, from);
    const Vec2 goal = place(to);
    while (!open.empty()) {
      const std::uint32_t i = open.top().second;
      open.pop();
      if (i == to) break;
      for (int d = 0; d < 8; ++d) {
        const auto j = neighbour(i, d);
        if (!j || is_blocked_[*j] || crosses_track(i, d)) continue;
        const double reached = costs[i] + cost(i, *j, d);
        if (reached >= costs[*j]) continue;
        costs[*j] = reached, before[*j] = i;
        open.emplace(reached + distance(place(*j), goal) * kAlongTrack, *j);
      }
    }
    if (before[to] == kNone) return std::nullopt;
    std::vector<std::uint32_t> path = {to};
    while (path.back() != from) path.push_back(before[path.back()]);
    return path;
  }

  Polyline line_from(std::uint32_t i, int d) {
    Polyline line = {places_[i]};
    const std::uint32_t first = i;
    while (true) {
      const std::uint32_t j = *neighbour(i, d);
      used_[i] &= static_cast<std::uint8_t>(~(1 << d));
      used_[j] &= static_cast<std::uint8_t>(~(1 << ((d + 4) % 8)));
      line.push_back(places_[j]);
      // the edge that was taken away counted too
      if (j == first || degree(j) != 1 || is_end_[j]) break;
      i = j, d = std::countr_zero(used_[j]);
    }
    return line;
  }

 public:
  /// Notes where tracks meet or end, before lines() takes edges away.
  void note_ends() {
    is_end_.assign(size(), false);
    for (std::uint32_t i = 0; i < size(); ++i) is_end_[i] = used_[i] != 0 && degree(i) != 2;
  }

 private:
  const Terrain& terrain_;
  int count_;
  double side_m_;
  std::vector<double> heights_m_;
  std::vector<bool> is_blocked_, is_wet_, is_end_;
  std::vector<Vec2> places_;
  std::vector<std::uint8_t> used_;
};

void smooth_track(Polyline& line) {
  for (int round = 0; round < 3; ++round) {
    const Polyline before = line;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      line[i] = before[i] * 0.5 + (before[i - 1] + before[i + 1]) * 0.25;
  }
}

double steepest(const Polyline& line, const Terrain& terrain) {
  double most = 0;
  for (std::size_t i = 0; i + 2 < line.size(); ++i) {
    const double run_m = distance(line[i], line[i + 1]) + distance(line[i + 1], line[i + 2]);
    if (run_m > 0) most = std::max(most, std::abs(terrain.height_m(line[i + 2]) - terrain.height_m(line[i])) / run_m);
  }
  return most;
}

/// Vertices of roads inside the square, where tracks may begin.
std::vector<Vec2> road_vertices(const InventedMap& map, double side_m) {
  std::vector<Vec2> vertices;
  for (const InventedLine& line : map.lines) {
    const std::string_view road = value_in(line.tags, "highway");
    if (road.empty() || road == "motorway" || road == "trunk" || road == "footway") continue;
    if (!value_in(line.tags, "bridge").empty() || !value_in(line.tags, "tunnel").empty()) continue;
    for (const Vec2 p : line.axis)
      if (std::max(std::abs(p.x), std::abs(p.y)) < side_m / 2 - kTrackStep_m) vertices.push_back(p);
  }
  return vertices;
}

/// A row of trees beside a track.
InventedLine row_beside(const Polyline& track, bool is_left) {
  // off the track's verge
  const double away_m = is_left ? 4.5 : -4.5;
  InventedLine row{{}, {{"leaf_type", "broadleaved"}, {"natural", "tree_row"}}};
  for (std::size_t i = 1; i + 1 < track.size(); ++i)
    row.axis.push_back(track[i] + left_of(unit(track[i + 1] - track[i - 1])) * away_m);
  return row;
}

/// A place on the border of the square.
Vec2 border_place(const RandomSequence& random, std::uint32_t index, double side_m) {
  const double along = random.between(-0.45, 0.45, index * 4) * side_m, half_m = side_m / 2;
  switch (random.below(4, index * 4 + 1)) {
    case 0:
      return {along, half_m};
    case 1:
      return {-half_m, along};
    case 2:
      return {along, -half_m};
    default:
      return {half_m, along};
  }
}

}  // namespace

void add_tracks(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                InventedMap& map) {
  const int wanted = static_cast<int>(settings.tracks_per_km2 * std::max(1.0, side_m * side_m / 1e6) + 0.5);
  if (wanted == 0) return;
  const RandomSequence random(seed, {}, "tracks");
  const std::vector<Vec2> roads = road_vertices(map, side_m);
  TrackGrid grid(terrain, map, side_m);
  for (std::uint32_t k = 0, tries = 0; static_cast<int>(k) < wanted && tries < 6U * wanted; ++tries) {
    const Vec2 from = roads.empty() ? border_place(random, 1000 + tries, side_m)
                                    : roads[random.below(static_cast<std::uint32_t>(roads.size()), tries * 4 + 2)];
    Vec2 to = border_place(random, tries, side_m);
    const double away_m = distance(from, to);
    if (away_m > kFarthest_m) to = from + (to - from) * (kFarthest_m / away_m);
    const std::uint32_t first = grid.nearest(from), last = grid.nearest(to);
    if (away_m < 150 || grid.is_blocked(last)) continue;
    if (!roads.empty() && !grid.join_road(first, from)) continue;
    if (grid.lay(first, last)) ++k;
  }
  grid.note_ends();
  std::uint32_t rows = 1U << 20;
  for (Polyline& line : grid.lines()) {
    smooth_track(line);
    const bool is_path = steepest(line, terrain) > kSteepestTrack;
    if (!is_path && line.size() > 6 && random.unit(++rows) < settings.tree_row_share)
      map.lines.push_back(row_beside(line, rows % 2 == 0));
    map.lines.push_back(
        {std::move(line), is_path ? Tags{{"highway", "path"}} : Tags{{"highway", "track"}, {"tracktype", "grade2"}}});
  }
}

}  // namespace citykiln::invent
