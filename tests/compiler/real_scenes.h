// Scenes of real extracts, and the land cover at a place, found by a test of every polygon instead of an index.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <vector>

#include "compiler/pipeline.h"
#include "tests/test_files.h"

namespace citykiln {

struct Extract {
  const char* map;
  const char* heights = nullptr;
};

inline scene::Scene scene_of(const Extract& extract, double tile_m) {
  CompileSpec spec;
  spec.map_path = real_data(extract.map);
  spec.tile_m = tile_m;
  if (extract.heights) spec.rasters.emplace_back().path = real_data(extract.heights);
  Result<CompileResult> compiled = compile(spec, [](auto&&...) {});
  EXPECT_TRUE(compiled) << extract.map;
  return compiled ? std::move(compiled->scene) : scene::Scene{};
}

inline std::vector<Box2> boxes_of(std::span<const ground::LandCoverPolygon> surfaces) {
  std::vector<Box2> boxes(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    for (const Ring& ring : surfaces[i].rings)
      for (const Vec2 p : ring) boxes[i].grow(p);
  return boxes;
}

/// Returns the polygon that covers a place; null if none does.
/// @param boxes  Boxes of the surfaces.
inline const ground::LandCoverPolygon* top_at(std::span<const ground::LandCoverPolygon> surfaces,
                                              std::span<const Box2> boxes, Vec2 p) {
  const ground::LandCoverPolygon* top = nullptr;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    if (!boxes[i].contains(p)) continue;
    int winding = 0;
    for (const Ring& ring : surfaces[i].rings) winding += winding_number(ring, p);
    if (winding > 0 && (!top || covers(surfaces[i], *top))) top = &surfaces[i];
  }
  return top;
}

}  // namespace citykiln
