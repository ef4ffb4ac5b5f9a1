#include "compiler/buildings/outline_index.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace citykiln::buildings {
namespace {

// About a town block; and no more than this many buckets along a side, whatever the extract.
constexpr double kBucket_m = 64;
constexpr int kMostBuckets = 1024;

int bucket_of(double offset_m, const OutlineIndex& index, int count) {
  return static_cast<int>(std::clamp(std::floor(offset_m / index.bucket_m), 0.0, count - 1.0));
}

void put(OutlineIndex& index, std::uint32_t outline, const Box2& box) {
  const int first_column = bucket_of(box.min.x - index.box.min.x, index, index.columns);
  const int last_column = bucket_of(box.max.x - index.box.min.x, index, index.columns);
  const int first_row = bucket_of(box.min.y - index.box.min.y, index, index.rows);
  const int last_row = bucket_of(box.max.y - index.box.min.y, index, index.rows);
  for (int row = first_row; row <= last_row; ++row)
    for (int column = first_column; column <= last_column; ++column)
      index.buckets[static_cast<std::size_t>(row) * index.columns + column].push_back(outline);
}

}  // namespace

OutlineIndex index_outlines(const std::vector<map::Footprint>& footprints) {
  OutlineIndex index{&footprints, {}, 0, 0, 0, {}};
  std::vector<Box2> boxes;
  for (const map::Footprint& footprint : footprints) {
    boxes.push_back(footprint.is_part ? Box2{} : box_of(footprint.polygon.outer));
    if (boxes.back().is_empty()) continue;
    index.box.grow(boxes.back().min);
    index.box.grow(boxes.back().max);
  }
  if (index.box.is_empty()) return index;
  index.bucket_m = std::max(kBucket_m, std::max(index.box.width(), index.box.height()) / kMostBuckets);
  index.columns = static_cast<int>(index.box.width() / index.bucket_m) + 1;
  index.rows = static_cast<int>(index.box.height() / index.bucket_m) + 1;
  index.buckets.resize(static_cast<std::size_t>(index.columns) * index.rows);
  for (std::uint32_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].is_empty()) put(index, i, boxes[i]);
  return index;
}

const map::Footprint* outline_at(const OutlineIndex& index, Vec2 p) {
  if (!index.box.contains(p)) return nullptr;
  const int column = bucket_of(p.x - index.box.min.x, index, index.columns);
  const int row = bucket_of(p.y - index.box.min.y, index, index.rows);
  const map::Footprint* best = nullptr;
  const auto rank = [](const map::Footprint& f) { return std::pair(area_m2(f.polygon), f.id); };
  for (const std::uint32_t i : index.buckets[static_cast<std::size_t>(row) * index.columns + column]) {
    const map::Footprint& outline = (*index.footprints)[i];
    if (!contains(outline.polygon, p)) continue;
    if (best == nullptr || rank(outline) < rank(*best)) best = &outline;
  }
  return best;
}

}  // namespace citykiln::buildings
