#include "preview/clouds/cloud_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "compiler/contract/system/for_each_slot.h"
#include "preview/turn.h"

namespace citykiln::preview {
namespace {

// Factors of each term relative to the one before: its light, the extinction on its way, and the mean cosine of its
// last scattering.
constexpr double kTermLight = 1, kTermExtinction = 0.28, kTermAsymmetry = 0.3;

// Droplets scatter half of their light by less than ten degrees, so shadows are cast by the rest.
constexpr double kShadowExtinction = 0.5;

// A ray ends where clouds let less than this share of light pass.
constexpr double kOpaque = 0.002;

// The optical depth of the first step into a cloud, and how much longer each is than the one before.
constexpr double kFirstStep = 0.5, kLongerStep = 1.3;

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

CloudField::CloudField(std::span<const sky::CloudLayer> layers, const CloudLight& light, Vec3 eye, double finest_rad,
                       int threads)
    : light_(light) {
  std::vector<sky::CloudLayer> upwards(layers.begin(), layers.end());
  std::ranges::stable_sort(upwards, {}, &sky::CloudLayer::base_m);
  for (const sky::CloudLayer& layer : upwards) layers_.push_back({CloudSpheres(layer, eye, finest_rad), {}});
  light_all(threads);
}

CloudField::CloudField(const sky::CloudLayer& layer, std::vector<sky::CloudParticle> spheres, const CloudLight& light,
                       CloudEdges edges)
    : light_(light) {
  layers_.push_back({CloudSpheres(layer, std::move(spheres), edges), {}});
  light_all(0);
}

void CloudField::light_all(int threads) {
  for (Layer& layer : layers_)
    layer.lit = for_each_slot<Lit>(layer.spheres.size(), threads,
                                   [&](std::size_t i) { return lit_at(layer.spheres.centre(i)); });
}

double CloudField::optical_depth(Vec3 from, Vec3 direction) const {
  double sum = 0;
  for (const Layer& layer : layers_) sum += layer.spheres.optical_depth(from, direction);
  return sum;
}

double CloudField::lowest_m() const {
  double lowest = kInfinity;
  for (const Layer& layer : layers_) lowest = std::min(lowest, layer.spheres.base_m());
  return lowest;
}

CloudField::Lit CloudField::lit_at(Vec3 at) const {
  const double from_sun = optical_depth(at, light_.to_sun);
  Lit lit{};
  double share = 1, extinction = 1;
  for (float& term : lit.sun) {
    term = static_cast<float>(share * std::exp(-extinction * from_sun));
    share *= kTermLight, extinction *= kTermExtinction;
  }
  lit.sky = static_cast<float>(passed_by_layer(optical_depth(at, {0, 0, 1})) / 2);
  lit.ground = static_cast<float>(passed_by_layer(optical_depth(at, {0, 0, -1})) / 2);
  return lit;
}

// A march along a ray through overlapping spheres of one layer, in steps between the places where spheres begin or end.
class CloudField::March {
 public:
  March(const CloudField& field, Vec3 direction, CloudPath& path) : field_(field), path_(path) {
    double g = kDropletAsymmetry;
    for (double& phase : phases_)
      phase = henyey_greenstein(dot(direction, field.light_.to_sun), g), g *= kTermAsymmetry;
  }

  void through(const Layer& layer, std::span<const SpherePart> parts) {
    layer_ = &layer, reached_m_ = 0, zero_m_ = parts.front().begin;
    sums_ = {}, density_ = {};
    for (const SpherePart& part : parts) {
      leave_until(part.begin);
      go_to(part.begin);
      if (path_.passed < kOpaque) break;
      change(part, 1);
      open_.push_back(part);
      std::ranges::push_heap(open_, ends_later);
    }
    leave_until(kInfinity);
  }

  double mean_distance_m() const { return seen_ > 0 ? distances_ / seen_ : 0; }

 private:
  static constexpr std::size_t kPowers = 5, kLights = 4;
  // Light of the sun, the sky and the ground, and the weights themselves, summed over the spheres that the ray is in.
  using Sums = std::array<double, kLights>;

  static bool ends_later(const SpherePart& a, const SpherePart& b) { return a.end > b.end; }

  // With w = 1 - (distance from its middle / radius)², a sphere adds w to the density, and its light has the weight w²,
  // whose slope is 0 at its surface too, so that no outlines are seen. Powers of the distance from `zero_m_`.
  void change(const SpherePart& part, double by) {
    const Lit& lit = layer_->lit[part.sphere];
    double sun = 0;
    for (int i = 0; i < kTerms; ++i) sun += lit.sun[i] * phases_[i];
    const double enter = part.enter - zero_m_, leave = part.leave - zero_m_;
    const double a = -enter * leave * part.scale, b = (enter + leave) * part.scale, c = -part.scale;
    const std::array<double, kPowers> squared = {a * a, 2 * a * b, b * b + 2 * a * c, 2 * b * c, c * c};
    const std::array<double, kLights> light = {sun * by, lit.sky * by, lit.ground * by, by};
    for (std::size_t p = 0; p < kPowers; ++p)
      for (std::size_t i = 0; i < kLights; ++i) sums_[p][i] += squared[p] * light[i];
    const double edge = by * layer_->spheres.edge_density(part.sphere);
    density_[0] += a * edge, density_[1] += b * edge, density_[2] += c * edge;
  }

  void leave_until(double until_m) {
    while (!open_.empty() && open_.front().end <= until_m) {
      go_to(open_.front().end);
      change(open_.front(), -1);
      std::ranges::pop_heap(open_, ends_later);
      open_.pop_back();
    }
    if (open_.empty()) sums_ = {}, density_ = {};
  }

  // Short steps, each longer than the one before.
  void go_to(double to_m) {
    const double first_m = kFirstStep / layer_->spheres.extinction_per_m();
    double step_m = first_m;
    while (!open_.empty() && reached_m_ < to_m && path_.passed >= kOpaque) {
      // no last step that is short
      const double next_m = to_m - reached_m_ > 1.5 * step_m ? reached_m_ + step_m : to_m;
      step(next_m);
      step_m *= kLongerStep;
    }
    reached_m_ = std::max(reached_m_, to_m);
  }

  // Adds the light of a step, which is the weighted mean of the spheres in its middle.
  void step(double to_m) {
    const double step_m = to_m - reached_m_, middle_m = (to_m + reached_m_) / 2;
    reached_m_ = to_m;
    const double t = middle_m - zero_m_;
    const auto at_middle = [&](std::size_t i) {
      return std::max(0.0, sums_[0][i] + t * (sums_[1][i] + t * (sums_[2][i] + t * (sums_[3][i] + t * sums_[4][i]))));
    };
    const double all = density_[0] + t * (density_[1] + t * density_[2]),
                 density = layer_->spheres.is_soft() ? std::clamp(all, 0.0, 1.0) : 1;
    const double here = path_.passed * -std::expm1(-density * layer_->spheres.extinction_per_m() * step_m);
    const double weights = at_middle(3), each = weights > 0 ? here / weights : 0;
    const CloudLight& light = field_.light_;
    path_.added = path_.added + light.sun * (at_middle(0) * each) + light.sky * (at_middle(1) * each) +
                  light.ground * (at_middle(2) * each);
    path_.passed -= here, seen_ += here, distances_ += here * middle_m;
  }

  const CloudField& field_;
  CloudPath& path_;
  const Layer* layer_ = nullptr;
  std::array<double, kTerms> phases_{};
  std::vector<SpherePart> open_;  // spheres that the ray is in: a heap, the one that ends first in front
  double reached_m_ = 0;
  double zero_m_ = 0;
  std::array<Sums, kPowers> sums_{};  // times the powers of the distance
  std::array<double, 3> density_{};
  double seen_ = 0, distances_ = 0;
};

CloudPath CloudField::along(Vec3 from, Vec3 direction, double distance_m) const {
  CloudPath path;
  March march(*this, direction, path);
  std::vector<SpherePart> parts;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    // the nearer one first
    const Layer& layer = layers_[direction.z >= 0 ? i : layers_.size() - 1 - i];
    layer.spheres.parts_of(from, direction, distance_m, parts);
    if (!parts.empty()) march.through(layer, parts);
  }
  path.distance_m = march.mean_distance_m();
  return path;
}

double CloudField::sun_passed(Vec3 from) const {
  return std::exp(-kShadowExtinction * optical_depth(from, light_.to_sun));
}

std::size_t CloudField::particles() const {
  std::size_t sum = 0;
  for (const Layer& layer : layers_) sum += layer.spheres.size();
  return sum;
}

std::size_t CloudField::clouds() const {
  std::size_t sum = 0;
  for (const Layer& layer : layers_) sum += layer.spheres.clouds();
  return sum;
}

}  // namespace citykiln::preview
