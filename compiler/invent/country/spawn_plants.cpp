#include "compiler/invent/country/spawn_plants.h"

#include <algorithm>
#include <cmath>

#include "compiler/contract/random_sequence.h"

namespace citykiln::invent {
namespace {

// ground within this distance counts for how level a spot is, with this weight against the height
constexpr double kLevelWithin_m = 20, kLevelWeight = 0.2;

double badness(const Terrain& terrain, const Spot& spot, Vec2 p) {
  const double height_m = terrain.height_m(p);
  double steep_m = 0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      steep_m += std::abs(terrain.height_m(p + Vec2{i * kLevelWithin_m / 2, j * kLevelWithin_m / 2}) - height_m);
  return std::abs(height_m - spot.height_m) + kLevelWeight * steep_m;
}

std::string height_text(double height_m) {
  const int centimetres = static_cast<int>(std::floor(height_m * 100 + 0.5));
  const std::string digits = std::to_string(centimetres % 100);
  return std::to_string(centimetres / 100) + "." + (digits.size() < 2 ? "0" : "") + digits;
}

void spawn(const Spawner& spawner, Vec2 spot, const RandomSequence& random, InventedMap& map) {
  const Vec2 middle = spot + Vec2{spawner.x_m, spawner.y_m};
  std::uint32_t number = 0;
  for (int row = 0; row < spawner.rows; ++row)
    for (int column = 0; column < spawner.columns; ++column, number += 4) {
      if (random.unit(number) >= spawner.probability) continue;
      const double away_m = spawner.jitter * spawner.cell_m / 2;
      const Vec2 cell = middle + Vec2{(column - spawner.columns / 2.0 + 0.5) * spawner.cell_m,
                                      (row - spawner.rows / 2.0 + 0.5) * spawner.cell_m};
      const Vec2 place =
          cell + Vec2{random.between(-away_m, away_m, number + 1), random.between(-away_m, away_m, number + 2)};
      const double height_m = spawner.height_m * random.between(spawner.low_scale, spawner.high_scale, number + 3);
      map.points.push_back(
          {place, {{"height", height_text(height_m)}, {"natural", "tree"}, {"species", spawner.species}}});
    }
}

}  // namespace

Vec2 find_spot(const Terrain& terrain, const Spot& spot) {
  if (spot.edge_m <= 0) return {};
  const double within_m = terrain.side_m / 2 - spot.edge_m;
  Vec2 best;
  double least = 1e300;
  for (int row = 0; row <= terrain.cells; ++row)
    for (int column = 0; column <= terrain.cells; ++column) {
      const Vec2 p = terrain.point(column, row);
      if (std::max(std::abs(p.x), std::abs(p.y)) > within_m) continue;
      if (const double here = badness(terrain, spot, p); here < least) least = here, best = p;
    }
  return best;
}

void spawn_plants(const std::vector<Spawner>& spawners, Vec2 spot, std::uint64_t seed, InventedMap& map) {
  for (std::size_t i = 0; i < spawners.size(); ++i)
    spawn(spawners[i], spot, RandomSequence(seed, stable_id({}, "spawner", i), "plants"), map);
}

}  // namespace citykiln::invent
