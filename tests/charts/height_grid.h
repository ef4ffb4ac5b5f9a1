// Surfaces through heights on a grid, by several methods, for the chart smooth.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace citykiln::charts {

/// Heights in metres at the nodes of a grid, row by row.
struct HeightGrid {
  int columns = 0, rows = 0;
  std::vector<double> heights_m;

  double at(int column, int row) const { return heights_m[static_cast<std::size_t>(row) * columns + column]; }
  /// The height of the nearest node.
  double nearest(int column, int row) const;
};

/// Returns each n-th column and row of a grid, from the first.
HeightGrid thinned(const HeightGrid& grid, int n);

/// A way to a surface through, or near, the nodes of a grid.
struct SurfaceMethod {
  std::string name;
  /// Returns the heights at n places a step of each way, from the first node to the last, nodes included. Costs
  /// O(places).
  std::function<HeightGrid(const HeightGrid& grid, int n)> refined;
};

/// The methods that chart_smooth compares. Steps count as square.
/// - two triangles a square; bilinear
/// - bicubic: Hermite patches with central differences (Catmull-Rom), and with limited slopes (map/plane/bicubic.h)
/// - PN: cubic Bezier triangles with the same slopes at their corners (Vlachos et al. 2001), moved up and down only
/// - Catmull-Clark: bicubic B-splines, which on a grid are its limit. With the nodes as control points it passes beside
///   them; through the nodes its control points are the solution of a linear system.
/// - thin plate: through the 6 x 6 nodes about each square, one surface a square
std::vector<SurfaceMethod> surface_methods();

/// The place of compile's method among surface_methods().
inline constexpr std::size_t kOfCompile = 4;

}  // namespace citykiln::charts
