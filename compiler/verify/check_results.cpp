#include "compiler/verify/check_results.h"

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

namespace {

// In the order of printing.
constexpr Check CheckResults::*kChecks[] = {&CheckResults::files,          &CheckResults::stale,
                                            &CheckResults::ledger,         &CheckResults::glb_bytes,
                                            &CheckResults::area,           &CheckResults::height,
                                            &CheckResults::seams,          &CheckResults::jumps,
                                            &CheckResults::roads,          &CheckResults::rivers,
                                            &CheckResults::lakes,          &CheckResults::footing,
                                            &CheckResults::standing,       &CheckResults::openings,
                                            &CheckResults::land,           &CheckResults::on_earth,
                                            &CheckResults::areas,          &CheckResults::tracks,
                                            &CheckResults::decks,          &CheckResults::parts,
                                            &CheckResults::trunks,         &CheckResults::things,
                                            &CheckResults::wires,          &CheckResults::assumed_pavements,
                                            &CheckResults::assumed_lamps,  &CheckResults::assumed_railings,
                                            &CheckResults::assumed_masts,  &CheckResults::assumed_yards,
                                            &CheckResults::assumed_hedges, &CheckResults::assumed_houses,
                                            &CheckResults::assumed_fronts, &CheckResults::parked_cars,
                                            &CheckResults::street_cars,    &CheckResults::street_furniture,
                                            &CheckResults::people,         &CheckResults::tileset,
                                            &CheckResults::tileset_boxes,  &CheckResults::tileset_errors,
                                            &CheckResults::tileset_seams};
// Printed if something was tested.
constexpr Check CheckResults::*kOptionalChecks[] = {&CheckResults::bend, &CheckResults::usd_layers,
                                                    &CheckResults::usd_same, &CheckResults::usd_scene};

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void add_check(Check& all, const Check& more) {
  all.tests += more.tests;
  append(all.failures, more.failures);
}

}  // namespace

std::vector<const Check*> all_of(const CheckResults& results) {
  std::vector<const Check*> all;
  for (const auto claim : kChecks) all.push_back(&(results.*claim));
  for (const auto claim : kOptionalChecks)
    if ((results.*claim).tests > 0) all.push_back(&(results.*claim));
  return all;
}

void add(CheckResults& results, const CheckResults& of_tile) {
  for (const auto claim : kChecks) add_check(results.*claim, of_tile.*claim);
  for (const auto claim : kOptionalChecks) add_check(results.*claim, of_tile.*claim);
  results.reference_errors = combined(results.reference_errors, of_tile.reference_errors);
  append(results.ways_into_walls, of_tile.ways_into_walls);
  append(results.blank_walls, of_tile.blank_walls);
}

}  // namespace citykiln::verify
