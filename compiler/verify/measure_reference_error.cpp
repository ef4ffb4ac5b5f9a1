#include "compiler/verify/measure_reference_error.h"

#include <cassert>
#include <cmath>

#include "compiler/contract/random_sequence.h"
#include "compiler/ground/cover/land_cover_index.h"
#include "compiler/ground/grading/bend_points.h"

namespace citykiln::verify {

ReferenceErrors combined(const ReferenceErrors& a, const ReferenceErrors& b) {
  const ReferenceErrors& worst = b.largest_m > a.largest_m ? b : a;
  return {a.places + b.places, a.over + b.over, worst.largest_m, worst.at};
}

ReferenceErrors measure_reference_errors(const ground::GradedTerrain& graded,
                                         std::span<const ground::LandCoverPolygon> surfaces,
                                         const ReferenceAt& reference_at, const Box2& box, int a_side) {
  assert(a_side > 0 && !box.is_empty());
  const ground::LandCoverIndex map = index_land_cover(surfaces, box);
  const RandomSequence draw(0, StableId{0}, "samples of the reference");
  ReferenceErrors reference_errors;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(a_side * a_side); ++i) {
    const double u = (i % a_side + draw.unit(2 * i)) / a_side, v = (i / a_side + draw.unit(2 * i + 1)) / a_side;
    const Vec2 p{box.min.x + u * box.width(), box.min.y + v * box.height()};
    const std::uint32_t surface = land_cover_at(map, p);
    const ground::FaceHeight face =
        surface == ground::kNoLandCover ? ground::FaceHeight{} : face_height_of(surfaces[surface]);
    if (face.level_m) continue;
    const double deviation_m =
        std::abs(layer_height_m(heights_at(graded, p), face.layer) - height_m_at(reference_at(p), p, face.layer));
    ++reference_errors.places, reference_errors.over += deviation_m > 2 * ground::kReferenceError_m;
    if (deviation_m > reference_errors.largest_m) reference_errors.largest_m = deviation_m, reference_errors.at = p;
  }
  return reference_errors;
}

}  // namespace citykiln::verify
