#include "preview/clouds/cloud_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "preview/turn.h"

namespace citykiln::preview {
namespace {

// Factors of each term relative to the one before: its light, the extinction on its way, and the mean cosine of its
// last scattering.
constexpr int kTerms = 4;
constexpr double kTermLight = 0.88, kTermExtinction = 0.34, kTermAsymmetry = 0.3;

// Droplets scatter half of their light by less than ten degrees, so shadows are cast by the rest.
constexpr double kShadowExtinction = 0.5;

// A ray ends where clouds let less than this share of light pass.
constexpr double kOpaque = 0.004;

// The optical depth of the first step into a cloud, and how much longer each is than the one before. A step is at most
// this share of the depth of soft edges.
constexpr double kFirstStep = 0.5, kLongerStep = 1.25, kOfEdge = 0.6;

// The least step beside clouds, as a share of the depth of soft edges.
constexpr double kLeastStep = 0.12;

// Ends of the parts of the way to the sun, and of the ways up and down, as shares of a layer's height.
constexpr std::array kToSun = {0.0, 0.03, 0.09, 0.2, 0.45, 1.0};
constexpr std::array kUpwards = {0.0, 0.2, 0.8};

// The step of shadow rays in depths of soft edges.
constexpr double kShadowStep = 1.5;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The diffuse light that passes a plane layer (Bohren, "Multiple scattering of light and some of its observable
// consequences", 1987).
double passed_by_layer(double optical_depth) { return 1 / (1 + 0.75 * (1 - kDropletAsymmetry) * optical_depth); }

Vec3 upwards(double turn, double z) { return at_height(on_circle(turn) * std::sqrt(1 - z * z), z); }

}  // namespace

double henyey_greenstein(double cosine, double g) {
  const double d = 1 + g * g - 2 * g * cosine;
  return (1 - g * g) / (4 * std::numbers::pi * d * std::sqrt(d));
}

CloudLight light_on_clouds(const sky::SkyModel& model) {
  CloudLight light{.to_sun = unit(model.to_sun)};
  light.sun = model.sun_radiance * (2 * std::numbers::pi * (1 - model.sun_cos_radius));
  constexpr int kAround = 16, kUp = 8;
  for (int row = 0; row < kUp; ++row)
    for (int i = 0; i < kAround; ++i)
      light.sky =
          light.sky + sky::radiance(model, upwards((i + 0.5) / kAround, (row + 0.5) / kUp)) * (1.0 / (kAround * kUp));
  light.ground = sky::ground_radiance(model);
  return light;
}

CloudField::CloudField(std::span<const sky::CloudLayer> layers, const CloudLight& light, Vec3 eye, double pixel_rad)
    : light_(light), pixel_rad_(pixel_rad) {
  std::vector<sky::CloudLayer> upwards(layers.begin(), layers.end());
  std::ranges::stable_sort(upwards, {}, &sky::CloudLayer::base_m);
  for (const sky::CloudLayer& layer : upwards) layers_.emplace_back(layer, eye);
}

CloudField::CloudField(const sky::CloudLayer& layer, std::span<const sky::CloudParticle> spheres,
                       const CloudLight& light, CloudEdges edges)
    : light_(light) {
  layers_.emplace_back(layer, spheres, edges);
}

double CloudField::lowest_m() const {
  double lowest = kInfinity;
  for (const CloudHeaps& layer : layers_) lowest = std::min(lowest, layer.base_m());
  return lowest;
}

namespace {

// The optical depth of a layer from a place of its frame on, by one sample in the middle of each part of a way.
// Farther parts have fewer billows.
double depth_by_parts(const CloudHeaps& heaps, Vec3 own, Vec3 along, double height_m, std::span<const double> ends,
                      double finest_m) {
  double sum_m = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double length_m = (ends[i + 1] - ends[i]) * height_m, middle_m = (ends[i + 1] + ends[i]) / 2 * height_m;
    sum_m += length_m * heaps.density(own + along * middle_m, std::max(finest_m, 2 * length_m));
  }
  return sum_m * heaps.extinction_per_m();
}

// The optical depth of a layer along a ray, in long steps.
double depth_along(const CloudHeaps& heaps, Vec3 from, Vec3 direction) {
  std::vector<HeapStretch> stretches;
  heaps.stretches_of(from, direction, kInfinity, stretches);
  const CloudHeaps::Ray ray = heaps.ray_of(from, direction);
  const double step_m = kShadowStep * heaps.soft_m() / ray.speed;
  double sum_m = 0;
  for (const HeapStretch& stretch : stretches) {
    for (double t = stretch.begin; t < stretch.end;) {
      const double next = std::min(t + step_m, stretch.end);
      const auto [density, free_m] =
          heaps.sample(ray.from + ray.along * ((t + next) / 2), stretch.column, heaps.soft_m());
      sum_m += density * (next - t);
      t = std::max(next, t + free_m / ray.speed);
    }
  }
  return sum_m * heaps.extinction_per_m();
}

}  // namespace

// A march along a ray through the layers of a field.
class CloudField::March {
 public:
  March(const CloudField& field, Vec3 from, Vec3 direction, CloudPath& path)
      : field_(field), from_(from), direction_(direction), path_(path) {
    double g = kDropletAsymmetry;
    for (double& phase : phases_)
      phase = henyey_greenstein(dot(direction, field.light_.to_sun), g), g *= kTermAsymmetry;
  }

  void through(const CloudHeaps& heaps, double distance_m, std::vector<HeapStretch>& stretches) {
    heaps_ = &heaps;
    heaps.stretches_of(from_, direction_, distance_m, stretches);
    if (stretches.empty()) return;
    ray_ = heaps.ray_of(from_, direction_);
    height_m_ = heaps.frame().height_m * heaps.frame().flatten;
    to_sun_ = heaps.frame().into_direction(field_.light_.to_sun);
    up_ = heaps.frame().into_direction({0, 0, 1});
    from_others_ = -1, reached_m_ = 0;
    step_m_ = first_step_m();
    for (const HeapStretch& stretch : stretches) {
      if (path_.passed < kOpaque) break;
      through(stretch);
    }
  }

  double mean_distance_m() const { return seen_ > 0 ? distances_ / seen_ : 0; }

 private:
  double first_step_m() const {
    return std::min(kFirstStep / heaps_->extinction_per_m(), kOfEdge * heaps_->soft_m() / ray_.speed);
  }

  // A step may end in the next stretch.
  void through(const HeapStretch& stretch) {
    double t = std::max(stretch.begin, reached_m_);
    const double least_m = kLeastStep * heaps_->soft_m() / ray_.speed;
    while (t < stretch.end && path_.passed >= kOpaque) {
      const double finest_m = field_.finest_m(t);
      const Vec3 own = ray_.from + ray_.along * t;
      const auto [density, free_m] = heaps_->sample(own, stretch.column, finest_m);
      if (density <= 0) {
        t += std::max({free_m / ray_.speed, least_m, finest_m / 2});
        step_m_ = first_step_m();
        continue;
      }
      const double step_m = std::max(step_m_, finest_m / 2);
      add(own, density, step_m, t);
      t += step_m, step_m_ *= kLongerStep;
    }
    // what is free in one column may not be in the next
    reached_m_ = std::min(t, stretch.end + step_m_);
  }

  // Adds the light of a step.
  void add(Vec3 own, double density, double step_m, double t) {
    const double here = path_.passed * -std::expm1(-density * heaps_->extinction_per_m() * step_m);
    const double finest_m = field_.finest_m(t);
    if (from_others_ < 0) from_others_ = depth_of_others(from_ + direction_ * t);
    const double from_sun =
        from_others_ + depth_by_parts(*heaps_, own, to_sun_, height_m_, std::span<const double>(kToSun), finest_m);
    double sun = 0, share = 1, extinction = 1;
    for (const double phase : phases_) {
      sun += share * phase * std::exp(-extinction * from_sun);
      share *= kTermLight, extinction *= kTermExtinction;
    }
    const auto layer_passed = [&](Vec3 along) {
      return passed_by_layer(
                 depth_by_parts(*heaps_, own, along, height_m_, std::span<const double>(kUpwards), finest_m)) /
             2;
    };
    const CloudLight& light = field_.light_;
    path_.added = path_.added + light.sun * (sun * here) + light.sky * (layer_passed(up_) * here) +
                  light.ground * (layer_passed(up_ * -1.0) * here);
    path_.passed -= here, seen_ += here, distances_ += here * t;
  }

  // The optical depth of the other layers on the way from the sun.
  double depth_of_others(Vec3 at) const {
    double sum = 0;
    for (const CloudHeaps& other : field_.layers_)
      if (&other != heaps_) sum += depth_along(other, at, field_.light_.to_sun);
    return sum;
  }

  const CloudField& field_;
  Vec3 from_, direction_;
  CloudPath& path_;
  const CloudHeaps* heaps_ = nullptr;
  CloudHeaps::Ray ray_{};
  Vec3 to_sun_{}, up_{};  // in the layer's frame, for one metre of the plane
  double height_m_ = 0, step_m_ = 0, reached_m_ = 0, from_others_ = -1;
  std::array<double, kTerms> phases_{};
  double seen_ = 0, distances_ = 0;
};

CloudPath CloudField::along(Vec3 from, Vec3 direction, double distance_m) const {
  CloudPath path;
  March march(*this, from, direction, path);
  std::vector<HeapStretch> stretches;
  for (std::size_t i = 0; i < layers_.size(); ++i)
    // the nearer one first
    march.through(layers_[direction.z >= 0 ? i : layers_.size() - 1 - i], distance_m, stretches);
  path.distance_m = march.mean_distance_m();
  return path;
}

double CloudField::sun_passed(Vec3 from) const {
  double sum = 0;
  for (const CloudHeaps& layer : layers_) sum += depth_along(layer, from, light_.to_sun);
  return std::exp(-kShadowExtinction * sum);
}

bool CloudField::is_empty() const {
  return std::ranges::all_of(layers_, [](const CloudHeaps& layer) { return layer.size() == 0; });
}

std::size_t CloudField::clouds() const {
  std::size_t sum = 0;
  for (const CloudHeaps& layer : layers_) sum += layer.clouds();
  return sum;
}

}  // namespace citykiln::preview
