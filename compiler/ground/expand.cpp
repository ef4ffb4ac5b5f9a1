#include "compiler/ground/expand.h"

#include <algorithm>

#include "compiler/ground/bend_borders.h"
#include "compiler/ground/carve_lines.h"
#include "compiler/ground/partition.h"
#include "compiler/ground/refine.h"
#include "compiler/ground/step_mesh.h"

namespace citykiln::ground {
namespace {

// How much finer than the tolerance borders are split at most.
constexpr double kFinestBorders = 8;

// The cell's own border is split at this share of the tolerance. A vertex close to a border that is off by a, where the
// border is off by b, leaves an edge between them that is off by at most a + b: two halves are the tolerance.
constexpr double kCellBorderShare = 0.5;

std::vector<HeightLayer> layers_of(std::span<const Surface> surfaces) {
  std::vector<HeightLayer> layers;
  for (const Surface& surface : surfaces) layers.push_back(layer_of(surface.surface));
  return layers;
}

std::vector<HeightLayer> face_layers(std::span<const std::uint32_t> face_surface, std::span<const HeightLayer> layers) {
  std::vector<HeightLayer> of_faces;
  for (const std::uint32_t surface : face_surface)
    of_faces.push_back(surface == kNoSurface ? HeightLayer::kLand : layers[surface]);
  return of_faces;
}

// Borders bent to the ground, and points between them, to the tolerance; borders inside the cell to a finer one.
Refined refined_to(const Reference& reference, std::span<const Border> borders, std::span<const HeightLayer> layers,
                   double tolerance_m, double inner_m) {
  const Bent bent = bend_to(reference, borders, layers, kCellBorderShare * tolerance_m, inner_m);
  Partition seen = partition_of(bent.borders, bent.points, reference.cell);
  std::vector<HeightLayer> of_faces = face_layers(seen.face_surface, layers);
  return refine(std::move(seen), std::move(of_faces), reference, tolerance_m);
}

Reference reference_on(Delaunay&& triangulation, const Carving& carving, const Box2& cell) {
  std::vector<Heights> heights;
  for (const GridPoint p : triangulation.vertices()) heights.push_back(heights_at(carving, plane_point(p)));
  return reference_of(std::move(triangulation), std::move(heights), cell);
}

}  // namespace

Reference reference_of_cell(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell) {
  Partition all = partition_all(layers_near(surfaces, cell), carve_lines(carving, cell), cell);
  return reference_on(std::move(all.triangulation), carving, cell);
}

GroundMesh expand_cell(std::span<const Surface> surfaces, const Carving& carving, const Box2& cell, double tolerance_m,
                       Report& report) {
  const std::vector<HeightLayer> layers = layers_of(surfaces);
  Partition all = partition_all(layers_near(surfaces, cell), carve_lines(carving, cell), cell);
  const std::vector<Border> borders = seen_borders(all);
  const Reference reference = reference_on(std::move(all.triangulation), carving, cell);

  // Where a border is off by nearly the tolerance, a sliver beside it can be off by more, too thin for a further
  // vertex: then the borders are split more finely. The cell's own border is not: its vertices are the neighbour's too.
  double inner_m = tolerance_m;
  Refined refined = refined_to(reference, borders, layers, tolerance_m, inner_m);
  while (refined.error_m > tolerance_m && inner_m > tolerance_m / kFinestBorders) {
    inner_m /= 2;
    refined = refined_to(reference, borders, layers, tolerance_m, inner_m);
  }
  if (refined.error_m > tolerance_m) report.add(Code::kToleranceNotMet, {}, refined.error_m);
  return step_mesh(refined, carving);
}

}  // namespace citykiln::ground
