#include "compiler/roads/markings/wear.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "compiler/map/land_cover_class.h"
#include "compiler/materials/material.h"

namespace citykiln::roads {
namespace {

using materials::Material;

// Shares of the asphalt's reflectance.
constexpr double kTyres = 1.10, kTyreEdge = 1.05, kOil = 0.90, kOilEdge = 0.95, kDirt = 0.82, kDirtEdge = 0.91,
                 kSeam = 0.62;
// Widths, metres; the track of cars is 1.4 to 1.6 m.
constexpr double kHalfTrack_m = 0.75, kTyres_m = 0.30, kTyreEdge_m = 0.60, kOil_m = 0.35, kOilEdge_m = 0.65,
                 kDirt_m = 0.25, kDirtEdge_m = 0.50, kSeam_m = 0.04, kLeastLane_m = 2.3;

bool has_tyre_bands(const map::Lane& lane) {
  return !lane.is_raised && lane.width_m >= kLeastLane_m &&
         (lane.kind == map::LaneKind::kDriving || lane.kind == map::LaneKind::kBus ||
          lane.kind == map::LaneKind::kTurn);
}

bool is_asphalt(const MarkingLayout& layout) {
  const Material material = map::values_of(layout.surface).material;
  return material == Material::kAsphalt || material == Material::kOldAsphalt;
}

class WearPainter {
 public:
  explicit WearPainter(const MarkingLayout& layout)
      : base_(materials::values_of(map::values_of(layout.surface).material).base_colour),
        width_m_(roads::width_m(layout)),
        length_m_(roads::length_m(layout)) {}

  void band(double middle_m, double wide_m, double share) {
    const double left = std::clamp(middle_m - wide_m / 2, 0.0, width_m_),
                 right = std::clamp(middle_m + wide_m / 2, 0.0, width_m_);
    if (right <= left) return;
    materials::TextureImage::Texel colour{};
    for (std::size_t c = 0; c < colour.size(); ++c) colour[c] = materials::srgb_of_linear(base_[c] * share);
    marks.push_back({rectangle({left, 0}, {right, length_m_}), colour});
  }

  Marks marks;

 private:
  std::array<float, 3> base_;
  double width_m_, length_m_;
};

void add_lane_wear(double left_m, double right_m, WearPainter& painter) {
  const double middle = (left_m + right_m) / 2;
  painter.band(middle, kOilEdge_m, kOilEdge), painter.band(middle, kOil_m, kOil);
  for (const double side : {-kHalfTrack_m, kHalfTrack_m}) {
    painter.band(middle + side, kTyreEdge_m, kTyreEdge);
    painter.band(middle + side, kTyres_m, kTyres);
  }
}

}  // namespace

Marks wear_of(const MarkingLayout& layout) {
  const auto& lanes = layout.lanes;
  if (layout.panel_m > 0 || !is_asphalt(layout) || std::ranges::none_of(lanes, has_tyre_bands)) return {};
  const std::vector<double> sides = lane_sides_m(layout);
  WearPainter painter(layout);
  for (std::size_t i = 0; i < lanes.size(); ++i)
    if (has_tyre_bands(lanes[i])) add_lane_wear(sides[i], sides[i + 1], painter);
  for (std::size_t i = 1; i < lanes.size(); ++i)
    if (has_tyre_bands(lanes[i - 1]) && has_tyre_bands(lanes[i])) painter.band(sides[i], kSeam_m, kSeam);
  const auto add_dirt = [&](double at_m) {
    painter.band(at_m, 2 * kDirtEdge_m, kDirtEdge), painter.band(at_m, 2 * kDirt_m, kDirt);
  };
  if (layout.has_kerb_left) add_dirt(0);
  if (layout.has_kerb_right) add_dirt(sides.back());
  return std::move(painter.marks);
}

}  // namespace citykiln::roads
