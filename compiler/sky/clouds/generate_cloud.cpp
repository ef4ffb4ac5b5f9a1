#include "compiler/sky/clouds/generate_cloud.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "compiler/contract/random_sequence.h"
#include "compiler/geometry/trig.h"

namespace citykiln::sky {
namespace {

// The number of levels of smaller particles on larger ones, and of particles on each.
constexpr int kMostLevels = 4;
constexpr std::uint32_t kOnEach = 14;
// The largest distance of the highest heap from a cloud's middle, as a share of the cloud's radius.
constexpr double kOffMiddle = 0.35;

// A place on the unit sphere above its southern cap: a spiral, turned at random.
Vec3 place_on_sphere(std::uint32_t i, double turn) {
  constexpr double kGoldenTurn = 0.38196601125010515, kLowest = -0.35;
  const double z = 1 - (i + 0.5) / kOnEach * (1 - kLowest);
  const Vec2 round = direction_of(turn + i * kGoldenTurn) * std::sqrt(std::max(0.0, 1 - z * z));
  return at_height(round, z);
}

bool is_inside(Vec3 p, const CloudParticle& sphere) {
  const Vec3 off = p - sphere.centre;
  return dot(off, off) < sphere.radius_m * sphere.radius_m * 0.999;
}

// Spheres side by side: a large one near the middle, and rings of smaller and lower ones that fill the outline.
std::vector<CloudParticle> first_level(const CloudLayer& layer, const Cloud& cloud) {
  const RandomSequence draw(layer.seed, cloud.id, "heap");
  const double tallest_m = cloud.height_m * 0.62;
  const double middle_m = std::min(tallest_m, cloud.radius_m * 0.75);
  const auto sits = [&](Vec2 offset, double radius_m) {
    return CloudParticle{at_height(cloud.centre + offset, std::min(radius_m, cloud.height_m - radius_m) * 0.55),
                         radius_m};
  };
  const RandomSequence tower(layer.seed, cloud.id, "tower");
  const Vec2 off = direction_of(tower.unit(0)) * (cloud.radius_m * kOffMiddle * tower.unit(1));
  std::vector<CloudParticle> spheres = {sits(off, middle_m)};
  const auto around = static_cast<std::uint32_t>(std::clamp(cloud.radius_m / middle_m * 5, 6.0, 24.0));
  for (std::uint32_t i = 0; i < 2 * around; ++i) {
    const bool is_outer = i >= around;
    const double turn = (i + draw.unit(3 * i)) / around, share = is_outer ? 0.78 : 0.45;
    const double radius_m =
        std::min(middle_m, cloud.radius_m * 0.42) * (is_outer ? 0.62 : 0.9) * draw.between(0.5, 1.3, 3 * i + 1);
    const double off_m = std::max(0.0, cloud.radius_m * share * draw.between(0.8, 1.1, 3 * i + 2));
    spheres.push_back(sits(direction_of(turn) * off_m, radius_m));
  }
  return spheres;
}

// A particle, the id for random numbers of the particles on it, and the particle below it.
struct Grown {
  CloudParticle sphere;
  StableId id{};
  CloudParticle below{};
};

// Adds smaller particles on the surface of one, down to a radius, where neither a heap nor the particle below hides
// them. They depend on nothing else, so that coarser clouds have equal ones. Returns the largest radius that was left
// out.
double add_on(std::uint64_t seed, const Grown& on, const std::vector<CloudParticle>& heaps, double finest_m,
              std::vector<Grown>& next) {
  double left_out_m = 0;
  const RandomSequence draw(seed, on.id, "particles");
  const double turn = draw.unit(0), root_m = on.sphere.radius_m;
  for (std::uint32_t i = 0; i < kOnEach; ++i) {
    const CloudParticle grown{on.sphere.centre + place_on_sphere(i, turn) * (root_m * 0.92),
                              root_m * draw.between(0.32, 0.52, 1 + i)};
    if (grown.centre.z < 0 || is_inside(grown.centre, on.below)) continue;
    const auto hides = [&](const CloudParticle& heap) {
      return heap.centre != on.sphere.centre && is_inside(grown.centre, heap);
    };
    if (std::ranges::any_of(heaps, hides)) continue;
    if (grown.radius_m < finest_m)
      left_out_m = std::max(left_out_m, grown.radius_m);
    else
      next.push_back({grown, stable_id(on.id, "particle", i), on.sphere});
  }
  return left_out_m;
}

}  // namespace

double extinction_per_m(CloudKind kind) {
  switch (kind) {
    case CloudKind::kStratus:
      return 0.03;
    case CloudKind::kCirrus:
      return 0.0003;
    default:
      return 0.045;
  }
}

CloudParticles generate_cloud(const CloudLayer& layer, const Cloud& cloud, double finest_m) {
  assert(finest_m > 0);
  CloudParticles all{.spheres = {}, .finest_m = finest_m, .depth_error = 0};
  double left_out_m = 0;
  const std::vector<CloudParticle> heaps = first_level(layer, cloud);
  std::vector<Grown> level;
  for (const CloudParticle& heap : heaps) level.push_back({heap, stable_id(cloud.id, "heap", level.size())});
  for (int depth = 0; !level.empty(); ++depth) {
    for (const Grown& grown : level) all.spheres.push_back(grown.sphere);
    if (depth + 1 >= kMostLevels) break;
    std::vector<Grown> next;
    for (const Grown& on : level) left_out_m = std::max(left_out_m, add_on(layer.seed, on, heaps, finest_m, next));
    level = std::move(next);
  }
  all.depth_error =
      extinction_per_m(layer.kind) * kMissedDiameters * 2 * left_out_m * std::max(frame_of(layer).stretch, 1.0);
  std::ranges::stable_sort(all.spheres, std::greater(), &CloudParticle::radius_m);
  return all;
}

std::pair<double, double> chord_of(const CloudParticle& sphere, Vec3 from, Vec3 direction) {
  const Vec3 off = from - sphere.centre;
  const double a = dot(direction, direction), b = dot(off, direction);
  const double root2 = b * b - a * (dot(off, off) - sphere.radius_m * sphere.radius_m);
  if (root2 <= 0) return {0, 0};
  const double root = std::sqrt(root2);
  return {(-b - root) / a, (-b + root) / a};
}

std::pair<double, double> above_base(std::pair<double, double> chord, Vec3 from, Vec3 direction) {
  const auto [begin, end] = chord;
  if (direction.z == 0) return from.z >= 0 ? chord : std::pair(0.0, 0.0);
  const double base = -from.z / direction.z;
  return direction.z > 0 ? std::pair(std::max(begin, base), end) : std::pair(begin, std::min(end, base));
}

std::pair<double, double> part_inside(const CloudParticle& sphere, Vec3 from, Vec3 direction) {
  return above_base(chord_of(sphere, from, direction), from, direction);
}

double optical_depth(CloudKind kind, const CloudParticles& particles, Vec3 from, Vec3 direction) {
  std::vector<std::pair<double, double>> parts;
  for (const CloudParticle& sphere : particles.spheres) {
    const auto [begin, end] = part_inside(sphere, from, direction);
    if (end > std::max(begin, 0.0)) parts.push_back({std::max(begin, 0.0), end});
  }
  std::ranges::sort(parts);
  double sum = 0, reached = 0;
  for (const auto& [begin, end] : parts) {
    sum += std::max(0.0, end - std::max(begin, reached));
    reached = std::max(reached, end);
  }
  return sum * extinction_per_m(kind);
}

double optical_depth_error(const CloudLayer& layer, const Cloud& cloud, double coarse_m, double finest_m, int rays) {
  const CloudParticles fine = generate_cloud(layer, cloud, finest_m), coarse = generate_cloud(layer, cloud, coarse_m);
  const RandomSequence draw(layer.seed, cloud.id, "rays");
  const double around_m = cloud.radius_m * 1.5 + cloud.height_m;
  double largest = 0;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rays); ++i) {
    const auto on_sphere = [&](std::uint32_t first) {
      const double z = draw.between(-1, 1, first);
      return at_height(direction_of(draw.unit(first + 1)) * std::sqrt(std::max(0.0, 1 - z * z)), z);
    };
    const Vec3 middle = at_height(cloud.centre, cloud.height_m / 2);
    const Vec3 from = middle + on_sphere(4 * i) * around_m, to = middle + on_sphere(4 * i + 2) * (around_m / 2);
    const Vec3 along = unit(to - from);
    largest = std::max(largest, std::abs(optical_depth(layer.kind, fine, from, along) -
                                         optical_depth(layer.kind, coarse, from, along)));
  }
  return largest;
}

}  // namespace citykiln::sky
