#include "compiler/invent/land/trace_rivers.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/segment.h"

namespace citykiln::invent {
namespace {

// each round moves points by a quarter of their bend: lattice steps become curves
constexpr int kSmoothings = 6;

class Tracer {
 public:
  Tracer(const Lattice& lattice, const Drainage& drainage, const TerrainSettings& settings,
         const std::vector<bool>& is_standing)
      : lattice_(lattice), drainage_(drainage), settings_(settings), is_standing_(is_standing) {
    inflows_.assign(lattice.size(), 0);
    for (std::uint32_t i = 0; i < lattice.size(); ++i)
      if (is_river(i) && drainage.receiver[i] != i && !is_standing[i]) ++inflows_[drainage.receiver[i]];
  }

  std::vector<TracedRiver> trace() const {
    std::vector<TracedRiver> rivers;
    for (std::uint32_t i = 0; i < lattice_.size(); ++i)
      if (is_start(i)) rivers.push_back(river_from(i));
    return rivers;
  }

 private:
  bool is_river(std::uint32_t i) const { return drainage_.area_m2[i] >= settings_.river_from_km2 * 1e6; }
  /// True for sources, confluences, and outlets of lakes.
  bool is_start(std::uint32_t i) const {
    const std::uint32_t to = drainage_.receiver[i];
    if (!is_river(i) || to == i) return false;
    if (is_standing_[i]) return !is_standing_[to];
    return inflows_[i] != 1;
  }

  double width_m(std::uint32_t i) const { return settings_.river_width_m * std::sqrt(drainage_.area_m2[i] / 1e6); }

  TracedRiver river_from(std::uint32_t first) const {
    TracedRiver traced;
    const auto add = [&](std::uint32_t i) {
      traced.river.axis.push_back(lattice_.place(i));
      traced.river.width_m.push_back(width_m(i));
      traced.levels_m.push_back(lattice_.heights_m[i]);
    };
    add(first);
    for (std::uint32_t at = first;;) {
      at = drainage_.receiver[at];
      add(at);
      if (drainage_.receiver[at] == at || is_standing_[at] || inflows_[at] != 1) break;
    }
    // the receiver drains the land of the confluence, and is as wide as the next river
    if (traced.river.width_m.size() > 1) traced.river.width_m.back() = *(traced.river.width_m.end() - 2);
    smooth(traced.river.axis);
    return traced;
  }

  static void smooth(Polyline& axis) {
    for (int round = 0; round < kSmoothings; ++round) {
      const Polyline before = axis;
      for (std::size_t i = 1; i + 1 < axis.size(); ++i)
        axis[i] = before[i] * 0.5 + (before[i - 1] + before[i + 1]) * 0.25;
    }
  }

  const Lattice& lattice_;
  const Drainage& drainage_;
  const TerrainSettings& settings_;
  const std::vector<bool>& is_standing_;
  std::vector<std::uint8_t> inflows_;
};

/// Lowers the points within a distance of a segment to the level of the nearest place on it.
void lower_to_segment(Lattice& lattice, const TracedRiver& traced, std::size_t k, const std::vector<bool>& is_fixed) {
  const Vec2 a = traced.river.axis[k], b = traced.river.axis[k + 1];
  const double half_m = lattice.cells * lattice.step_m / 2;
  const double within_m = traced.river.width_m[k] / 2 + lattice.step_m * 1.05;
  const auto cell = [&](double v) {
    return std::clamp(static_cast<int>((v + half_m) / lattice.step_m), 0, lattice.cells);
  };
  for (int row = cell(std::min(a.y, b.y) - within_m); row <= cell(std::max(a.y, b.y) + within_m); ++row)
    for (int column = cell(std::min(a.x, b.x) - within_m); column <= cell(std::max(a.x, b.x) + within_m); ++column) {
      const std::size_t i = lattice.index(column, row);
      const Vec2 p{column * lattice.step_m - half_m, row * lattice.step_m - half_m};
      const double share = nearest_share(a, b, p);
      if (distance(a + (b - a) * share, p) > within_m || (!is_fixed.empty() && is_fixed[i])) continue;
      const double level_m = traced.levels_m[k] + (traced.levels_m[k + 1] - traced.levels_m[k]) * share;
      lattice.heights_m[i] = std::min(lattice.heights_m[i], level_m);
    }
}

}  // namespace

std::vector<TracedRiver> trace_rivers(const Lattice& lattice, const Drainage& drainage, const TerrainSettings& settings,
                                      const std::vector<bool>& is_standing) {
  return Tracer(lattice, drainage, settings, is_standing).trace();
}

void lower_to_rivers(Lattice& lattice, const std::vector<TracedRiver>& rivers, const std::vector<bool>& is_fixed) {
  for (const TracedRiver& traced : rivers)
    for (std::size_t k = 0; k + 1 < traced.river.axis.size(); ++k) lower_to_segment(lattice, traced, k, is_fixed);
}

}  // namespace citykiln::invent
