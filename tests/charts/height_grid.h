// Surfaces through a grid of heights, by several methods, for the chart "smooth".
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace citykiln::charts {

/// A grid of heights in metres, stored row by row. Its nodes are the points (column, row).
struct HeightGrid {
  int columns = 0, rows = 0;
  std::vector<double> heights_m;

  double at(int column, int row) const { return heights_m[static_cast<std::size_t>(row) * columns + column]; }
  /// The height of the node nearest to a column and row, which may lie outside of the grid.
  double nearest(int column, int row) const;
};

/// Returns the grid of every n-th column and row, from the first on.
HeightGrid thinned(const HeightGrid& grid, int n);

/// A method that makes a surface through, or near, the nodes of a grid.
struct SurfaceMethod {
  std::string name;
  /// Returns the heights of the surface on a grid with n steps for each step of the nodes, from the
  /// first node to the last. It costs O(places).
  std::function<HeightGrid(const HeightGrid& grid, int n)> refined;
};

/// The methods that chart_smooth compares. A step has the same length along columns and rows.
/// - two triangles for each square; bilinear
/// - bicubic: Hermite patches with central differences (Catmull-Rom), and with limited slopes
///   (map/plane/bicubic.h)
/// - PN: cubic Bezier triangles with the slopes of central differences at their corners (Vlachos et
///   al. 2001), with control points moved only up and down
/// - Catmull-Clark: its limit on a grid, bicubic B-splines. With the nodes as control points the
///   surface passes beside them. Control points for a surface through the nodes are the solution of
///   a linear system.
/// - thin plate: for each square, one surface through the 6 x 6 nodes about it
std::vector<SurfaceMethod> surface_methods();

/// The index in surface_methods() of the method that `citykiln compile` uses.
inline constexpr std::size_t kOfCompile = 4;

}  // namespace citykiln::charts
