#include "grammars/derivation/form_roofs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "grammars/roofs/generate_roof.h"
#include "tests/grammars/on_lot.h"

namespace citykiln::grammars {
namespace {

const std::vector<Polygon> kFootprints = {
    {{{0, 0}, {12, 0}, {12, 8}, {0, 8}}, {}},
    {{{0, 0}, {14, 0}, {14, 6}, {6, 6}, {6, 12}, {0, 12}}, {}},
    {{{0, 0}, {20, 0}, {20, 16}, {0, 16}}, {{{6, 5}, {6, 11}, {14, 11}, {14, 5}}}},
};

/// The length of the sum of all area vectors: 0 for a closed surface, however its faces meet.
double open_area_m2(const Derivation& derivation) {
  Vec3 sum;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) sum = sum + double_area_vector_m2(face);
  return length(sum);
}

Derivation roofed(const Polygon& footprint, const std::string& roof) {
  DeriveOptions options;
  options.roofs = form_roofs(0.01);
  const Program program = program_of("Lot --> extrude(6) comp(f) { top : " + roof + " | all : Wall. }");
  const Derivation derivation = derive(program, lot(footprint, 3, 0, StableId{1}, {0}), options);
  EXPECT_TRUE(derivation.warnings.empty()) << roof;
  return derivation;
}

TEST(FormRoofs, CloseTheHouse) {
  for (const Polygon& footprint : kFootprints)
    for (const char* roof : {"roofGable(40)", "roofHip(35)", "roofPyramid(byHeight, 4)", "roofShed(15)"}) {
      const Derivation derivation = roofed(footprint, std::string(roof) + " comp(f) { bottom : NIL | all : R. }");
      EXPECT_NEAR(open_area_m2(derivation), 0, 1e-6) << roof;
      EXPECT_GE(count_named(derivation, "R"), 2u) << roof;
    }
}

TEST(FormRoofs, OfOnePlaneAreOneFace) {
  const Derivation derivation =
      roofed(kFootprints[0], "roofGable(45) comp(f) { bottom : NIL | side : Gable. | top : Tiles. }");
  EXPECT_EQ(count_named(derivation, "Tiles"), 2u);
  EXPECT_EQ(count_named(derivation, "Gable"), 2u);
}

TEST(FormRoofs, StandOut) {
  const Derivation derivation =
      roofed(kFootprints[0], "roofHip(35, 0.5) comp(f) { border : Eaves. | bottom : NIL | top : Tiles. }");
  double low_x = 0;
  for (const Terminal* tiles : named(derivation, "Tiles"))
    for (const Vec3 p : tiles->faces.at(0).outer) low_x = std::min(low_x, p.x);
  EXPECT_NEAR(low_x, -0.5, 0.01);
  EXPECT_GT(count_named(derivation, "Eaves"), 0u);
}

TEST(FormRoofs, BendWhereTheyAreAsked) {
  const Derivation derivation =
      roofed(kFootprints[0], "roofMansard(70, 20, 2.5) comp(f) { bottom : NIL | top : Tiles. | all : R. }");
  EXPECT_EQ(count_named(derivation, "Tiles"), 8u);
  const auto tangent = [](double angle_deg) { return std::tan(angle_deg * std::numbers::pi / 180); };
  std::set<double> heights_m;
  for (const Terminal* tiles : named(derivation, "Tiles"))
    for (const Vec3 p : tiles->faces.at(0).outer) heights_m.insert(std::floor((p.z - 9) * 10 + 0.5) / 10);
  const double ridge_m = 2.5 + (4 - 2.5 / tangent(70)) * tangent(20);
  EXPECT_EQ(heights_m, (std::set<double>{0, 2.5, std::floor(ridge_m * 10 + 0.5) / 10}));
}

TEST(FormRoofs, BendNowhereIfTheSlopesDoNotMeet) {
  for (const char* roof : {"roofMansard(30, 20, 9)", "roofMansard(60, 30, 0)"}) {
    const Derivation derivation =
        roofed(kFootprints[0], std::string(roof) + " comp(f) { bottom : NIL | top : Tiles. | all : R. }");
    EXPECT_EQ(count_named(derivation, "Tiles"), 4u) << roof;
    double top_m = 0;
    for (const Terminal* tiles : named(derivation, "Tiles"))
      for (const Vec3 p : tiles->faces.at(0).outer) top_m = std::max(top_m, p.z - 9);
    EXPECT_NEAR(top_m, 4 * std::tan(30 * std::numbers::pi / 180), 0.01) << roof;
  }
}

TEST(FormRoofs, AreNotBuiltWhereThereIsNoGrid) {
  RoofRequest request;
  request.kind = RoofKind::kGable;
  request.footprint = kFootprints[0];
  request.angle_deg = 30;
  EXPECT_TRUE(form_roofs(0.01)(request));
  for (const double overhang_m : {-0.5, 101.0, 1e6}) {
    request.overhang_m = overhang_m;
    EXPECT_FALSE(form_roofs(0.01)(request));
  }
  request.overhang_m = 0.5;
  for (Vec2& p : request.footprint.outer) p = p * 1e5;
  EXPECT_FALSE(form_roofs(0.01)(request));
}

TEST(FormRoofs, ShedsRiseFromTheirEdge) {
  const Derivation derivation = roofed(kFootprints[0], "roofShed(byHeight, 2, 0) comp(f) { top : Tiles. | all : NIL }");
  const Ring3& tiles = named(derivation, "Tiles").at(0)->faces.at(0).outer;
  EXPECT_EQ(tiles.size(), 4u);
  for (const Vec3 p : tiles) EXPECT_NEAR(p.z, 9 + p.y / 4, 0.01);
}

std::vector<Face> faces_on(const Polygon& footprint, roofs::RoofForm form, double overhang_m) {
  roofs::RoofShape shape;
  shape.form = form, shape.overhang_m = overhang_m;
  Report ignored;
  return faces_of(roofs::generate_roof(footprint, shape, 0.01, {}, ignored));
}

double tagged_area_m2(const std::vector<Face>& faces, FaceTag tag) {
  double sum_m2 = 0;
  for (const Face& face : faces) sum_m2 += face.tag == tag ? area_m2(face) : 0;
  return sum_m2;
}

// A rim goes around corners, so it has to be one face on each side.
TEST(FacesOfRoofs, HaveRimsAllAround) {
  const std::vector<Face> faces = faces_on(kFootprints[0], roofs::RoofForm::kFlat, 0.5);
  const double under_m2 = 13 * 9 - 12 * 8, around_m = 2 * (13 + 9), thickness_m = 0.1875;
  EXPECT_NEAR(tagged_area_m2(faces, FaceTag::kBorder), under_m2 + around_m * thickness_m, 1e-6);
}

// The soffit around a courtyard is inside of the hole of the outer soffit.
TEST(FacesOfRoofs, KnowWhichRingAHoleIsIn) {
  for (const Face& face : faces_on(kFootprints[2], roofs::RoofForm::kFlat, 0.5))
    for (const Ring3& hole : face.holes)
      EXPECT_GT(length(double_area_vector_m2(face.outer)), length(double_area_vector_m2(hole)));
  EXPECT_NEAR(tagged_area_m2(faces_on(kFootprints[2], roofs::RoofForm::kFlat, 0.5), FaceTag::kTop), 21 * 17 - 7 * 5,
              0.1);
}

// Three bays have three gables on each side, which meet in points.
TEST(FacesOfRoofs, ComeApartWhereTheyTouch) {
  const std::vector<Face> faces = faces_on({{{0, 0}, {24, 0}, {24, 10}, {0, 10}}, {}}, roofs::RoofForm::kGabledRow, 0);
  EXPECT_EQ(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.tag == FaceTag::kSide; }), 6);
}

// The roof plane over a wall with a bend of a centimetre is not planar.
TEST(FacesOfRoofs, AreFlat) {
  const Polygon bent{{{0, 0}, {8, -0x1p-6}, {16, 0}, {16, 10}, {0, 10}}, {}};
  for (const double overhang_m : {0.0, 0.5}) {
    const std::vector<Face> faces = faces_on(bent, roofs::RoofForm::kHipped, overhang_m);
    EXPECT_GE(faces.size(), 5u);
    for (const Face& face : faces) {
      const Vec3 normal = normal_of(face);
      each_vertex(face, [&](const Vec3& p) { EXPECT_NEAR(dot(p - face.outer[0], normal), 0, 0.01); });
    }
  }
}

}  // namespace
}  // namespace citykiln::grammars
