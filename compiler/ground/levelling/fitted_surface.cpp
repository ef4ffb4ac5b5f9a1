#include "compiler/ground/levelling/fitted_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace citykiln::ground {
namespace {

constexpr std::size_t kMostTerms = 6;
// The scale of Cauchy's weights is at least this, so that exact points keep their weight.
constexpr double kLeastScale_m = 0.05;

using Terms = std::array<double, kMostTerms>;

Terms terms_at(Vec2 off, double unit_m) {
  const double x = off.x / unit_m, y = off.y / unit_m;
  return {1, x, y, x * x, x * y, y * y};
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Solves the symmetric system by elimination; terms without any data stay 0.
Terms solved(std::array<Terms, kMostTerms> matrix, Terms right, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) {
    if (matrix[k][k] < 1e-9) continue;
    for (std::size_t row = k + 1; row < count; ++row) {
      const double factor = matrix[row][k] / matrix[k][k];
      for (std::size_t column = k; column < count; ++column) matrix[row][column] -= factor * matrix[k][column];
      right[row] -= factor * right[k];
    }
  }
  Terms found{};
  for (std::size_t k = count; k-- > 0;) {
    if (matrix[k][k] < 1e-9) continue;
    double sum = right[k];
    for (std::size_t column = k + 1; column < count; ++column) sum -= matrix[k][column] * found[column];
    found[k] = sum / matrix[k][k];
  }
  return found;
}

// Points about their mean place, in units of their extent.
struct SurfaceFit {
  std::span<const Vec3> points;
  std::size_t count;
  Vec2 centre{};
  double unit_m = 1;
  Terms found{};

  double height_m(const Vec3& p) const {
    const Terms terms = terms_at(Vec2{p.x, p.y} - centre, unit_m);
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) sum += found[k] * terms[k];
    return sum;
  }

  void place_about_mean() {
    for (const Vec3& p : points) centre = centre + Vec2{p.x, p.y};
    centre = centre * (1.0 / static_cast<double>(points.size()));
    for (const Vec3& p : points) unit_m = std::max({unit_m, std::abs(p.x - centre.x), std::abs(p.y - centre.y)});
  }

  void solve(std::span<const double> weights) {
    std::array<Terms, kMostTerms> matrix{};
    Terms right{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Terms terms = terms_at(Vec2{points[i].x, points[i].y} - centre, unit_m);
      for (std::size_t row = 0; row < count; ++row) {
        right[row] += weights[i] * terms[row] * points[i].z;
        for (std::size_t column = 0; column < count; ++column)
          matrix[row][column] += weights[i] * terms[row] * terms[column];
      }
    }
    found = solved(matrix, right, count);
  }

  std::vector<double> residuals_m() const {
    std::vector<double> off_m;
    for (const Vec3& p : points) off_m.push_back(p.z - height_m(p));
    return off_m;
  }
};

void reweight(const SurfaceFit& fit, std::vector<double>& weights) {
  const std::vector<double> off_m = fit.residuals_m();
  std::vector<double> distances_m;
  for (const double off : off_m) distances_m.push_back(std::abs(off));
  const double scale_m = std::max(kLeastScale_m, median_of(distances_m));
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double off = off_m[i] / scale_m;
    weights[i] = 1 / (1 + off * off);
  }
}

FittedSurface in_metres(const SurfaceFit& fit) {
  const double u = fit.unit_m;
  const Terms& f = fit.found;
  return {fit.centre, {f[0], f[1] / u, f[2] / u, f[3] / (u * u), f[4] / (u * u), f[5] / (u * u)}};
}

void limit_slope(FittedSurface& surface, std::span<const Vec3> points, double most_slope) {
  double steepest = 0;
  for (const Vec3& p : points) steepest = std::max(steepest, length(surface.gradient({p.x, p.y})));
  if (steepest <= most_slope) return;
  for (std::size_t k = 1; k < kMostTerms; ++k) surface.coefficients[k] *= most_slope / steepest;
  std::vector<double> off_m;
  for (const Vec3& p : points) off_m.push_back(p.z - surface.height_m({p.x, p.y}));
  surface.coefficients[0] += median_of(std::move(off_m));
}

}  // namespace

double FittedSurface::height_m(Vec2 p) const {
  const Terms terms = terms_at(p - centre, 1);
  double sum = 0;
  for (std::size_t k = 0; k < kMostTerms; ++k) sum += coefficients[k] * terms[k];
  return sum;
}

Vec2 FittedSurface::gradient(Vec2 p) const {
  const Vec2 off = p - centre;
  const auto& [c0, east, north, east2, both, north2] = coefficients;
  return {east + 2 * east2 * off.x + both * off.y, north + both * off.x + 2 * north2 * off.y};
}

FittedSurface fitted_surface(std::span<const Vec3> points, SurfaceForm form, double most_slope) {
  if (points.empty()) return {};
  SurfaceFit fit{points, form == SurfaceForm::kPlane ? std::size_t{3} : kMostTerms};
  fit.place_about_mean();
  std::vector<double> weights(points.size(), 1.0);
  for (int round = 0; round < kFitRounds; ++round) {
    fit.solve(weights);
    reweight(fit, weights);
  }
  FittedSurface surface = in_metres(fit);
  limit_slope(surface, points, most_slope);
  return surface;
}

}  // namespace citykiln::ground
