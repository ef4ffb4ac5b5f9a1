#include "tests/charts/height_grid.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/geometry/vec.h"
#include "compiler/map/plane/bicubic.h"

namespace citykiln::charts {
namespace {

// Heights about a square: (0, 0) to (1, 1) are its corners.
struct AboutSquare {
  const HeightGrid& grid;
  int column, row;
  double operator()(int c, int r) const { return grid.nearest(column + c, row + r); }
};

// A height at shares of a step beyond the first corner of a square.
using HeightInSquare = std::function<double(const AboutSquare& z, double u, double v)>;

// Surfaces of which each square knows its own heights.
SurfaceMethod by_squares(std::string name, const HeightInSquare& height) {
  return {std::move(name), [height](const HeightGrid& grid, int n) {
            HeightGrid fine{(grid.columns - 1) * n + 1, (grid.rows - 1) * n + 1, {}};
            for (int r = 0; r < fine.rows; ++r)
              for (int c = 0; c < fine.columns; ++c) {
                const int column = std::min(c / n, grid.columns - 2), row = std::min(r / n, grid.rows - 2);
                fine.heights_m.push_back(
                    height({grid, column, row}, double{1} * (c - column * n) / n, double{1} * (r - row * n) / n));
              }
            return fine;
          }};
}

double two_triangles(const AboutSquare& z, double u, double v) {
  return u >= v ? z(0, 0) + (z(1, 0) - z(0, 0)) * u + (z(1, 1) - z(1, 0)) * v
                : z(0, 0) + (z(0, 1) - z(0, 0)) * v + (z(1, 1) - z(0, 1)) * u;
}

double bilinear(const AboutSquare& z, double u, double v) {
  return (z(0, 0) * (1 - u) + z(1, 0) * u) * (1 - v) + (z(0, 1) * (1 - u) + z(1, 1) * u) * v;
}

double limited_bicubic(const AboutSquare& z, double u, double v) { return map::smooth_height<double>(z, u, v); }

double catmull_rom(const AboutSquare& z, double u, double v) {
  const auto along = [](const std::array<double, 4>& p, double t) {
    const auto w = map::hermite_weights(t);
    return p[1] * w.first + p[2] * w.second + (p[2] - p[0]) / 2 * w.first_slope + (p[3] - p[1]) / 2 * w.second_slope;
  };
  std::array<double, 4> rows{};
  for (int r = 0; r < 4; ++r)
    rows[static_cast<std::size_t>(r)] = along({z(-1, r - 1), z(0, r - 1), z(1, r - 1), z(2, r - 1)}, u);
  return along(rows, v);
}

struct Corner {
  Vec2 at;
  double z;
  Vec2 slope;
};

Corner corner_at(const AboutSquare& z, int c, int r) {
  return {
      Vec2{double{1} * c, double{1} * r}, z(c, r), {(z(c + 1, r) - z(c - 1, r)) / 2, (z(c, r + 1) - z(c, r - 1)) / 2}};
}

// The control point at a third of the way from a corner to another.
double edge_control(const Corner& from, const Corner& to) { return from.z + dot(from.slope, to.at - from.at) / 3; }

double pn_triangle(const std::array<Corner, 3>& corners, const std::array<double, 3>& w) {
  double height = 0, edges = 0, ends = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const double near_i = edge_control(corners[i], corners[j]), near_j = edge_control(corners[j], corners[i]);
    height += corners[i].z * w[i] * w[i] * w[i] + 3 * near_i * w[i] * w[i] * w[j] + 3 * near_j * w[i] * w[j] * w[j];
    edges += (near_i + near_j) / 6, ends += corners[i].z / 3;
  }
  return height + 6 * (edges + (edges - ends) / 2) * w[0] * w[1] * w[2];
}

double pn_triangles(const AboutSquare& z, double u, double v) {
  const Corner first = corner_at(z, 0, 0), last = corner_at(z, 1, 1);
  if (u >= v) return pn_triangle({first, corner_at(z, 1, 0), last}, {1 - u, u - v, v});
  return pn_triangle({first, last, corner_at(z, 0, 1)}, {1 - v, u, v - u});
}

// Weights of four control points of a uniform cubic B-spline.
std::array<double, 4> spline_weights(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6};
}

double spline(const AboutSquare& z, double u, double v) {
  const std::array<double, 4> across = spline_weights(u), along = spline_weights(v);
  double height = 0;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      height += along[static_cast<std::size_t>(r)] * across[static_cast<std::size_t>(c)] * z(c - 1, r - 1);
  return height;
}

// Replaces values by control points of a spline through them, by elimination; ends repeat.
void to_controls(std::vector<double>& values) {
  std::vector<double> share(values.size());
  const auto main = [&](std::size_t i) { return i == 0 || i + 1 == values.size() ? 5.0 : 4.0; };
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double pivot = main(i) - (i > 0 ? share[i - 1] : 0);
    share[i] = 1 / pivot;
    values[i] = (6 * values[i] - (i > 0 ? values[i - 1] : 0)) / pivot;
  }
  for (std::size_t i = values.size() - 1; i-- > 0;) values[i] -= share[i] * values[i + 1];
}

HeightGrid controls_through(HeightGrid grid) {
  const auto replace = [&](int count, std::size_t first, std::size_t step) {
    std::vector<double> line;
    for (int i = 0; i < count; ++i) line.push_back(grid.heights_m[first + i * step]);
    to_controls(line);
    for (int i = 0; i < count; ++i) grid.heights_m[first + i * step] = line[static_cast<std::size_t>(i)];
  };
  const auto across = static_cast<std::size_t>(grid.columns);
  for (int r = 0; r < grid.rows; ++r) replace(grid.columns, static_cast<std::size_t>(r) * across, 1);
  for (int c = 0; c < grid.columns; ++c) replace(grid.rows, static_cast<std::size_t>(c), across);
  return grid;
}

constexpr int kPlate = 6, kPlateNodes = kPlate * kPlate;

Vec2 plate_node(int k) { return {k % kPlate - 2.0, k / kPlate - 2.0}; }

// The kernel of thin plates, r² log r.
double plate_kernel(Vec2 a, Vec2 b) {
  const double r2 = dot(a - b, a - b);
  return r2 > 0 ? r2 * std::log(r2) / 2 : 0;
}

// The inverse of the linear system of a thin plate through the nodes.
Eigen::MatrixXd plate_inverse() {
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(kPlateNodes + 3, kPlateNodes + 3);
  for (int i = 0; i < kPlateNodes; ++i) {
    const Vec2 a = plate_node(i);
    for (int j = 0; j < kPlateNodes; ++j) system(i, j) = plate_kernel(a, plate_node(j));
    const std::array<double, 3> plane{1, a.x, a.y};
    for (int k = 0; k < 3; ++k)
      system(i, kPlateNodes + k) = system(kPlateNodes + k, i) = plane[static_cast<std::size_t>(k)];
  }
  return system.inverse();
}

// The weights of the nodes' heights at n x n places in a square.
std::vector<Eigen::VectorXd> plate_weights(int n) {
  const Eigen::MatrixXd inverse = plate_inverse();
  std::vector<Eigen::VectorXd> weights;
  for (int k = 0; k <= n; ++k)
    for (int i = 0; i <= n; ++i) {
      const Vec2 p{double{1} * i / n, double{1} * k / n};
      Eigen::VectorXd here(kPlateNodes + 3);
      for (int j = 0; j < kPlateNodes; ++j) here(j) = plate_kernel(p, plate_node(j));
      here.tail(3) << 1, p.x, p.y;
      weights.emplace_back((inverse * here).head(kPlateNodes));
    }
  return weights;
}

HeightGrid thin_plates(const HeightGrid& grid, int n) {
  const std::vector<Eigen::VectorXd> weights = plate_weights(n);
  return by_squares("",
                    [&](const AboutSquare& z, double u, double v) {
                      const auto place = static_cast<std::size_t>(std::lround(v * n) * (n + 1) + std::lround(u * n));
                      double height = 0;
                      for (int k = 0; k < kPlateNodes; ++k)
                        height += weights[place](k) * z(k % kPlate - 2, k / kPlate - 2);
                      return height;
                    })
      .refined(grid, n);
}

}  // namespace

double HeightGrid::nearest(int column, int row) const {
  return at(std::clamp(column, 0, columns - 1), std::clamp(row, 0, rows - 1));
}

HeightGrid thinned(const HeightGrid& grid, int n) {
  HeightGrid coarse{(grid.columns - 1) / n + 1, (grid.rows - 1) / n + 1, {}};
  for (int r = 0; r < coarse.rows; ++r)
    for (int c = 0; c < coarse.columns; ++c) coarse.heights_m.push_back(grid.at(c * n, r * n));
  return coarse;
}

std::vector<SurfaceMethod> surface_methods() {
  const SurfaceMethod near = by_squares("Catmull-Clark beside the samples", spline);
  return {by_squares("two triangles", two_triangles),
          by_squares("bilinear", bilinear),
          by_squares("PN triangles", pn_triangles),
          by_squares("bicubic, central differences", catmull_rom),
          by_squares("bicubic, limited slopes (compile)", limited_bicubic),
          near,
          {"Catmull-Clark through the samples",
           [near](const HeightGrid& grid, int n) { return near.refined(controls_through(grid), n); }},
          {"thin plate of 6 x 6 samples", thin_plates}};
}

}  // namespace citykiln::charts
