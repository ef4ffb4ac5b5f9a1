#include "compiler/invent/country/add_country.h"

#include <algorithm>
#include <cmath>

#include "compiler/invent/country/add_farm_fields.h"
#include "compiler/invent/country/add_tracks.h"
#include "compiler/invent/country/taken_land.h"
#include "compiler/invent/land/contour.h"
#include "compiler/invent/land/noise.h"

namespace citykiln::invent {
namespace {

// the step of contours: finer ones would follow the noise of the terrain
constexpr double kCoverStep_m = 12;

// woods keep off towns and roads by so much, softly
constexpr double kOffTown_m = 10, kSoftly_m = 60;

// land above is too cold for trees, softly over 150 m: the Alps' tree line
constexpr double kTreeLine_m = 1850, kTreeLineSoftness_m = 150;
constexpr double kLeastCover_m2 = 900;

// The slope over some tens of metres: that of single cells is noise.
double slope_at(const Terrain& terrain, Vec2 p) {
  const double d = std::max(terrain.step_m(), kCoverStep_m);
  const double east = (terrain.height_m({p.x + d, p.y}) - terrain.height_m({p.x - d, p.y})) / (2 * d),
               north = (terrain.height_m({p.x, p.y + d}) - terrain.height_m({p.x, p.y - d})) / (2 * d);
  return std::sqrt(east * east + north * north);
}

// Returns the value that a share of all values exceeds: their (1 - share) quantile; 0 without values.
double upper_quantile(double share, std::vector<double> values) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>((1 - share) * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
  return values[rank];
}

class WildCover {
 public:
  WildCover(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
            const TakenLand& taken)
      : terrain_(terrain), settings_(settings), side_m_(side_m), seed_(seed) {
    free_ = grid([&](Vec2 p) { return std::min(taken.distance_m(p, kSoftly_m) - kOffTown_m, kSoftly_m) / kSoftly_m; });
    slope_ = grid([&](Vec2 p) { return slope_at(terrain_, p); });
    noise_ = grid([&](Vec2 p) { return fractal_noise(p * (1 / settings_.wood_size_m), 4, seed_ + 101); });
    second_noise_ = grid([&](Vec2 p) { return fractal_noise(p * (2.2 / settings_.wood_size_m), 3, seed_ + 211); });
    make_rock();
    make_wood();
    make_heath();
  }

  std::vector<Polygon> rock() const { return area_above_zero(rock_, kLeastCover_m2); }
  std::vector<Polygon> scree() const {
    return area_above_zero(combined([&](std::size_t i) {
                             return std::min({slope_.values[i] - settings_.rock_slope * 0.78 + noise_.values[i] * 0.08,
                                              -rock_.values[i], -wood_.values[i], free_.values[i]});
                           }),
                           kLeastCover_m2);
  }
  std::vector<Polygon> wood(bool is_needleleaved) const {
    return area_above_zero(combined([&](std::size_t i) {
                             const double needles = needle_share(i);
                             return std::min(wood_.values[i], is_needleleaved ? needles : -needles);
                           }),
                           kLeastCover_m2);
  }
  std::vector<Polygon> heath() const { return area_above_zero(heath_, kLeastCover_m2); }
  std::vector<Polygon> grassland() const {
    return area_above_zero(
        combined([&](std::size_t i) {
          return std::min({-rock_.values[i], -wood_.values[i], -heath_.values[i], free_.values[i] + 0.17});
        }),
        kLeastCover_m2);
  }

 private:
  template <typename At>
  ValueGrid grid(At at) const {
    return value_grid(side_m_ + 4 * kCoverStep_m, kCoverStep_m, at);
  }
  template <typename At>
  ValueGrid combined(At at) const {
    ValueGrid result = free_;
    for (std::size_t i = 0; i < result.values.size(); ++i) result.values[i] = at(i);
    return result;
  }
  double height_m(std::size_t i) const {
    return terrain_.height_m(free_.point(static_cast<int>(i % free_.columns), static_cast<int>(i / free_.columns)));
  }

  void make_rock() {
    rock_ = combined([&](std::size_t i) {
      return std::min(slope_.values[i] - settings_.rock_slope + noise_.values[i] * 0.15, free_.values[i]);
    });
  }

  /// Gentle land has the share of wood that is asked for; steep land has more, as it is worth less.
  void make_wood() {
    const double least = upper_quantile(settings_.wood_share, noise_.values);
    wood_ = combined([&](std::size_t i) {
      const double steep = std::clamp((slope_.values[i] - settings_.farm_field_slope) * 1.2, 0.0, 0.5);
      const double cold = std::max(0.0, (height_m(i) - kTreeLine_m) / kTreeLineSoftness_m);
      return std::min({noise_.values[i] - least + (settings_.wood_share > 0 ? steep : 0) - cold, -rock_.values[i],
                       free_.values[i]});
    });
  }

  void make_heath() {
    const double least = upper_quantile(settings_.heath_share, second_noise_.values);
    heath_ = combined([&](std::size_t i) {
      return std::min({second_noise_.values[i] - least, -wood_.values[i], -rock_.values[i], free_.values[i]});
    });
  }

  /// Above zero where trees have needles: high up, and in stands that foresters planted.
  double needle_share(std::size_t i) const { return (height_m(i) - 900) / 600 + second_noise_.values[i] - 0.05; }

  const Terrain& terrain_;
  const CountrySettings& settings_;
  double side_m_;
  std::uint64_t seed_;
  ValueGrid free_, slope_, noise_, second_noise_, rock_, wood_, heath_;
};

// Adds wild land cover to a map and to the taken land, which is indexed again. Areas keep off towns and roads by some
// metres. With fields, the rest stays free; without, it becomes grassland.
void add_wild_cover(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                    TakenLand& taken, InventedMap& map) {
  const WildCover cover(terrain, settings, side_m, seed, taken);
  const auto add = [&](std::vector<Polygon> polygons, const Tags& tags) {
    for (Polygon& polygon : polygons) {
      taken.add(polygon);
      map.areas.push_back({std::move(polygon), tags});
    }
  };
  add(cover.rock(), {{"natural", "bare_rock"}});
  add(cover.scree(), {{"natural", "scree"}});
  add(cover.wood(false), {{"leaf_type", "broadleaved"}, {"natural", "wood"}});
  add(cover.wood(true), {{"leaf_type", "needleleaved"}, {"natural", "wood"}});
  add(cover.heath(), {{"natural", "heath"}});
  if (!settings.has_farm_fields) add(cover.grassland(), {{"natural", "grassland"}});
  taken.index();
}

}  // namespace

void add_country(const Terrain& terrain, const CountrySettings& settings, double side_m, std::uint64_t seed,
                 InventedMap& map) {
  add_tracks(terrain, settings, side_m, seed, map);
  TakenLand taken = taken_land_of(map, terrain, true);
  taken.index();
  add_wild_cover(terrain, settings, side_m, seed, taken, map);
  if (settings.has_farm_fields) add_farm_fields(terrain, settings, side_m, seed, taken, map);
}

}  // namespace citykiln::invent
