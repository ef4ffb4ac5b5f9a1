#include "grammars/operations/operations.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grammars/shapes/cut.h"
#include "grammars/shapes/measure.h"
#include "tests/grammars/on_lot.h"
#include "tests/grammars/plain_roof.h"

namespace citykiln::grammars {
namespace {

std::vector<Face> all_faces(const Derivation& derivation) {
  std::vector<Face> faces;
  for (const Terminal& terminal : derivation.terminals)
    faces.insert(faces.end(), terminal.faces.begin(), terminal.faces.end());
  return faces;
}

double shape_volume_m3(const std::vector<Face>& faces) {
  Shape shape;
  shape.faces = faces;
  return volume_m3(shape);
}

double derived_area_m2(const Derivation& derivation) {
  double sum = 0;
  for (const Face& face : all_faces(derivation)) sum += area_m2(face);
  return sum;
}

Derivation on(const Polygon& footprint, const std::string& text) {
  return derive(program_of(text), lot(footprint, 0, 0, StableId{1}, {0}), {});
}

const Polygon kL = {{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 8}, {0, 8}}, {}};
const Polygon kCourt = {{{0, 0}, {20, 0}, {20, 16}, {0, 16}}, {{{6, 5}, {6, 11}, {14, 11}, {14, 5}}}};

// ---- solids

TEST(Extrude, MakesAClosedSolidOutward) {
  for (const Polygon& footprint : {rectangle(10, 8), kL, kCourt}) {
    const auto faces = all_faces(on(footprint, "Lot --> extrude(5)"));
    EXPECT_TRUE(is_closed(faces));
    EXPECT_NEAR(shape_volume_m3(faces), area_m2(footprint) * 5, 1e-9);
  }
}

TEST(Extrude, BelowZeroIsASolidToo) {
  const auto faces = all_faces(derived("Lot --> extrude(-5)"));
  EXPECT_TRUE(is_closed(faces));
  EXPECT_NEAR(shape_volume_m3(faces), 400, 1e-9);
}

TEST(Extrude, UpIsUpWhereverTheFaceLooks) {
  const auto derivation = derived("Lot --> extrude(4) comp(f) { front : extrude(world.up, 2) X | all : NIL }");
  EXPECT_EQ(derivation.terminals.size(), 1u);
  double top_m = 0;
  for (const Face& face : all_faces(derivation))
    for (const Vec3 p : face.outer) top_m = std::max(top_m, p.z);
  EXPECT_EQ(top_m, 6);
}

TEST(Extrude, SetsTheScopesHeight) {
  EXPECT_EQ(derived("Lot --> extrude(5) print(scope.sy) X").printed.front(), "5");
  EXPECT_EQ(derived("Lot --> extrude(5) comp(f) { front : extrude(2) print(scope.sz) X | all : NIL }").printed.front(),
            "2");
}

TEST(Taper, IsAPyramid) {
  const auto faces = all_faces(derived("Lot --> taper(6)"));
  EXPECT_TRUE(is_closed(faces));
  EXPECT_NEAR(shape_volume_m3(faces), 10 * 8 * 6 / 3.0, 1e-9);
}

TEST(Roofs, AreClosedSolids) {
  for (const char* rule : {"roofPyramid(45)", "roofPyramid(byHeight, 3)", "roofShed(20)", "roofShed(byHeight, 3, 1)"}) {
    const auto faces = all_faces(derived(std::string("Lot --> ") + rule));
    EXPECT_TRUE(is_closed(faces)) << rule;
    EXPECT_GT(shape_volume_m3(faces), 0) << rule;
  }
  EXPECT_NEAR(shape_volume_m3(all_faces(derived("Lot --> roofShed(byHeight, 3)"))), 10 * 8 * 1.5, 0.1);
  EXPECT_NEAR(shape_volume_m3(all_faces(derived("Lot --> roofPyramid(45)"))), 10 * 8 * 4 / 3.0, 0.1);
}

TEST(Roofs, ThatCannotBeBuiltStayFlatWithAWarning) {
  EXPECT_EQ(first_warning("Lot --> roofGable(0)"),
            "test.cga:1:9: 'roofGable' is not built on this shape; it stays flat");
  EXPECT_EQ(derived("Lot --> roofHip(-30) X").terminals.size(), 1u);
}

TEST(Roofs, AreAskedOfTheBuilder) {
  DeriveOptions options;
  RoofRequest asked;
  options.roofs = [&](const RoofRequest& request) {
    asked = request;
    RoofRequest plain = request;
    plain.kind = RoofKind::kPyramid;
    plain.overhang_m = 0;
    return plain_roof(plain);
  };
  const auto derivation =
      derived("Lot --> extrude(3) comp(f) { top : roofGable(30, 0.5, 0.4, true) comp(f) { top : R | bottom : B } }", 10,
              8, options);
  EXPECT_EQ(asked.kind, RoofKind::kGable);
  EXPECT_EQ(asked.angle_deg, 30);
  EXPECT_EQ(asked.overhang_m, 0.5);
  EXPECT_NEAR(signed_area_m2(asked.footprint.outer), 80, 1e-9);
  EXPECT_EQ(count_named(derivation, "R"), 4u);
  EXPECT_EQ(count_named(derivation, "B"), 1u);
  // the roof is on top of the walls
  for (const Terminal* roof : named(derivation, "R"))
    for (const Vec3 p : roof->faces[0].outer) EXPECT_GE(p.z, 3 - 1e-9);
}

// ---- parts

TEST(Comp, NamesSidesByTheScope) {
  const auto derivation =
      derived("Lot --> extrude(5) comp(f) { front : F | back : B | left : L | right : R | top : T | bottom : U }");
  const auto normal = [&](const char* name) { return normal_of(named(derivation, name).at(0)->faces[0]); };
  EXPECT_EQ(derivation.terminals.size(), 6u);
  EXPECT_EQ(normal("F"), (Vec3{0, -1, 0}));
  EXPECT_EQ(normal("B"), (Vec3{0, 1, 0}));
  EXPECT_EQ(normal("L"), (Vec3{-1, 0, 0}));
  EXPECT_EQ(normal("R"), (Vec3{1, 0, 0}));
  EXPECT_EQ(normal("T"), (Vec3{0, 0, 1}));
  EXPECT_EQ(normal("U"), (Vec3{0, 0, -1}));
}

TEST(Comp, TheFirstSelectorThatFitsHasTheFace) {
  const auto derivation = derived("Lot --> extrude(5) comp(f) { street : S | 0 : Zero | side : W | horizontal : H }");
  EXPECT_EQ(count_named(derivation, "S"), 1u);
  EXPECT_EQ(count_named(derivation, "Zero"), 1u);
  EXPECT_EQ(count_named(derivation, "W"), 3u);
  EXPECT_EQ(count_named(derivation, "H"), 1u);
}

TEST(Comp, AnEqualSignMakesOneShapeOfAll) {
  const auto derivation = derived("Lot --> extrude(5) comp(f) { side = W | all : NIL }");
  ASSERT_EQ(derivation.terminals.size(), 1u);
  EXPECT_EQ(derivation.terminals[0].faces.size(), 4u);
}

TEST(Comp, CountsItsComponents) {
  EXPECT_EQ(derived("Lot --> extrude(5) comp(f) { side : print(comp.index + \" of \" + comp.total) W }").printed,
            (std::vector<std::string>{"0 of 4", "1 of 4", "2 of 4", "3 of 4"}));
}

TEST(Comp, AFacesScopeStandsOnItsFoot) {
  const auto derivation = derived("Lot --> extrude(5) comp(f) { right : W }");
  const Scope& scope = derivation.terminals.at(0).scope;
  EXPECT_EQ(scope.axis[0], (Vec3{0, 1, 0}));
  EXPECT_EQ(scope.axis[1], (Vec3{0, 0, 1}));
  EXPECT_EQ(scope.axis[2], (Vec3{1, 0, 0}));
  EXPECT_EQ(scope.origin, (Vec3{10, 0, 0}));
  EXPECT_EQ(scope.size_m, (std::array<double, 3>{8, 5, 0}));
}

TEST(Comp, SaysWhichWordItDoesNotKnow) {
  EXPECT_NE(first_warning("Lot --> extrude(1) comp(f) { forehead : A }").find("'comp' has no selector 'forehead'"),
            std::string::npos);
}

TEST(Split, PiecesHaveTheSizesAsked) {
  const auto derivation = derived("Lot --> split(x) { 2 : A | '0.3 : B | ~1 : C }");
  EXPECT_NEAR(area_m2_of(derivation, "A"), 16, 1e-9);
  EXPECT_NEAR(area_m2_of(derivation, "B"), 24, 1e-9);
  EXPECT_NEAR(area_m2_of(derivation, "C"), 40, 1e-9);
}

TEST(Split, CutsSolidsIntoSolids) {
  const auto derivation = on(kCourt, "Lot --> extrude(9) split(y) { { ~3 : Floor }* }");
  ASSERT_EQ(derivation.terminals.size(), 3u);
  for (const Terminal& floor : derivation.terminals) {
    EXPECT_TRUE(is_closed(floor.faces));
    EXPECT_NEAR(shape_volume_m3(floor.faces), area_m2(kCourt) * 3, 1e-6);
  }
}

TEST(Split, CutsConcaveFacesAndThoseWithHoles) {
  for (const Polygon& footprint : {kL, kCourt})
    for (const char* axis : {"x", "z"})
      EXPECT_NEAR(
          derived_area_m2(on(footprint, std::string("Lot --> split(") + axis + ") { { ~1.3 : A | 0.4 : B }* }")),
          area_m2(footprint), 1e-9);
}

TEST(Split, TellsIndexAndTotal) {
  EXPECT_EQ(
      derived("Lot --> split(x) { 1 : X | { ~3 : X }* | 1 : X }\nX --> print(split.index + \"/\" + split.total) Y")
          .printed,
      (std::vector<std::string>{"0/5", "1/5", "2/5", "3/5", "4/5"}));
}

TEST(Split, AStarBehindTheBracesRepeatsAll) {
  EXPECT_EQ(derived("Lot --> split(x) { 2.5 : A }*").terminals.size(), 4u);
}

TEST(Split, SaysWhereThereIsNothingToSplit) {
  EXPECT_EQ(first_warning("Lot --> split(y) { 1 : A }"),
            "test.cga:1:9: the shape has no size along y; it is not split");
}

TEST(Setback, CutsBandsAlongTheEdgesAsked) {
  const auto derivation = derived("Lot --> setback(2) { front : F | left : L | remainder : R }");
  EXPECT_NEAR(area_m2_of(derivation, "F") + area_m2_of(derivation, "L"), 10 * 2 + 6 * 2, 1e-9);
  EXPECT_NEAR(area_m2_of(derivation, "R"), 8 * 6, 1e-9);
  EXPECT_EQ(count_named(derivation, "F"), 1u);
}

TEST(Setback, HasNoBandsWithoutArea) {
  for (const char* depth : {"0", "1e-9", "1e-4"}) {
    const auto derivation = derived("Lot --> setback(" + std::string(depth) + ") { all : A | remainder : B }");
    EXPECT_EQ(count_named(derivation, "A"), 0u) << depth;
    EXPECT_NEAR(area_m2_of(derivation, "B"), 80, 1e-9) << depth;
  }
}

TEST(Setback, CoversTheFaceWhateverItsDepth) {
  for (const Polygon& footprint : {kL, kCourt})
    for (const double depth : {0.3, 1.9, 2.4, 3.5, 30.0, 1e12})
      EXPECT_NEAR(
          derived_area_m2(on(footprint, "Lot --> setback(" + std::to_string(depth) + ") { all : A | remainder : B }")),
          area_m2(footprint), 0.01)
          << depth;
}

TEST(Setback, FramesARoundAWindow) {
  const auto derivation =
      derived("Lot --> extrude(3) comp(f) { front : setback(0.1) { all = Frame | remainder : Glass } | all : NIL }");
  EXPECT_EQ(count_named(derivation, "Frame"), 1u);
  EXPECT_NEAR(area_m2_of(derivation, "Frame"), 10 * 3 - 9.8 * 2.8, 1e-9);
  EXPECT_NEAR(area_m2_of(derivation, "Glass"), 9.8 * 2.8, 1e-9);
}

// A square: vertical, facing south, or horizontal, facing up or down.
Face tagged(FaceTag tag, Vec3 normal) {
  Face face;
  face.outer = normal.z == 0 ? Ring3{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}
                             : Ring3{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  if (normal.z < 0) face = reversed(face);
  face.tag = tag;
  return face;
}

TEST(Comp, GoesByTheTagsOfAMass) {
  const Vec3 south{0, -1, 0}, up{0, 0, 1}, down{0, 0, -1};
  Shape mass = lot_of(1, 1);
  mass.faces = {tagged(FaceTag::kSide, south),   tagged(FaceTag::kSide, south),  tagged(FaceTag::kVertical, south),
                tagged(FaceTag::kBorder, south), tagged(FaceTag::kBorder, down), tagged(FaceTag::kInside, south),
                tagged(FaceTag::kBottom, down),  tagged(FaceTag::kTop, up)};
  mass.faces[0].street = mass.faces[2].street = mass.faces[3].street = true;
  const Program program = program_of(
      "Lot --> comp(f) { bottom : Floor. | inside : Blank. | street : Street. | side : Wall. | vertical : Gable. "
      "| border : Eaves. | top : Roof. }");
  const Derivation derivation = derive(program, mass, {});
  for (const char* once : {"Floor", "Blank", "Street", "Wall", "Gable", "Roof"})
    EXPECT_EQ(count_named(derivation, once), 1u) << once;
  EXPECT_EQ(count_named(derivation, "Eaves"), 2u);
}

TEST(Offset, ShrinksAndGrows) {
  EXPECT_NEAR(derived_area_m2(derived("Lot --> offset(-1, inside)")), 8 * 6, 1e-9);
  EXPECT_NEAR(derived_area_m2(derived("Lot --> offset(-1, border)")), 80 - 48, 1e-9);
  EXPECT_NEAR(derived_area_m2(derived("Lot --> offset(1, inside)")), 12 * 10, 1e-9);
  const auto parts = derived("Lot --> offset(-1) comp(f) { inside : I | border : B }");
  EXPECT_NEAR(area_m2_of(parts, "I"), 48, 1e-9);
  EXPECT_EQ(count_named(parts, "B"), 4u);
}

TEST(Shapes, AreStripsInFrontAndAtTheSides) {
  const auto l = derived("Lot --> shapeL(3, 2) { shape : S | remainder : R }");
  EXPECT_NEAR(area_m2_of(l, "R"), 8 * 5, 1e-9);
  EXPECT_EQ(count_named(l, "S"), 1u);
  EXPECT_NEAR(area_m2_of(l, "S"), 40, 1e-9);
  // the front is south and left is west, so the remainder is in the north east
  EXPECT_EQ(named(l, "R")[0]->faces[0].outer.size(), 4u);
  for (const Vec3 p : named(l, "R")[0]->faces[0].outer) EXPECT_TRUE(p.x >= 2 - 1e-9 && p.y >= 3 - 1e-9);
  EXPECT_NEAR(area_m2_of(derived("Lot --> shapeU(3, 1, 2) { shape : S | remainder : R }"), "R"), 7 * 5, 1e-9);
  const auto o = derived("Lot --> shapeO(3, 1, 1, 2) { shape : S | remainder : R }");
  EXPECT_NEAR(area_m2_of(o, "R"), 7 * 4, 1e-9);
  ASSERT_EQ(count_named(o, "S"), 1u);
  EXPECT_EQ(named(o, "S")[0]->faces.at(0).holes.size(), 1u);
  EXPECT_TRUE(is_closed(all_faces(derived("Lot --> shapeO(3, 1, 1, 2) { shape : extrude(4) S }"))));
}

TEST(InnerRectangle, LiesInsideAndTheRestIsLeft) {
  const auto derivation = on(kL, "Lot --> innerRectangle(scope) { shape : S | remainder : R }");
  EXPECT_NEAR(area_m2_of(derivation, "S"), 40, 1e-9);
  EXPECT_NEAR(derived_area_m2(derivation), area_m2(kL), 1e-9);
  const Polygon triangle = {{{0, 0}, {9, 0}, {0, 6}}, {}};
  EXPECT_GT(area_m2_of(on(triangle, "Lot --> innerRectangle(edge) { shape : S | remainder : R }"), "S"), 9);
}

// ---- movements

TEST(Movements, GoAlongTheScopesAxes) {
  const auto derivation = derived("Lot --> t('0.5, 2, -1) X");
  EXPECT_EQ(derivation.terminals[0].scope.origin, (Vec3{5, 9, 2}));
}

TEST(Movements, TurnsComeBack) {
  const auto derivation = derived("Lot --> r(scopeCenter, 10, 20, 30) r(0, 0, -30) r(0, -20, 0) r(-10, 0, 0) X");
  const auto turned = derived("Lot --> r(scopeCenter, 0, 90, 0) X");
  EXPECT_NEAR(derived_area_m2(derivation), 80, 1e-9);
  EXPECT_NEAR(turned.terminals[0].scope.axis[0].y, turned.terminals[0].scope.axis[2].x, 1e-12);
  EXPECT_NEAR(std::abs(dot(turned.terminals[0].scope.axis[0], Vec3{0, 1, 0})), 1, 1e-12);
}

TEST(Movements, SizesScaleTheGeometry) {
  EXPECT_NEAR(derived_area_m2(derived("Lot --> s('0.5, 0, 4)")), 5 * 4, 1e-9);
  const auto cube = derived("Lot --> s('1, 3, '1) primitiveCube()");
  EXPECT_TRUE(is_closed(all_faces(cube)));
  EXPECT_NEAR(shape_volume_m3(all_faces(cube)), 240, 1e-9);
}

TEST(Movements, CenterGoesToTheMiddleOfWhatItCameFrom) {
  const auto derivation = derived("Lot --> split(x) { 4 : s(2, 0, 2) center(xz) X }");
  EXPECT_NEAR(derivation.terminals[0].scope.centre().x, 5, 1e-9);
  EXPECT_NEAR(derivation.terminals[0].scope.centre().y, 4, 1e-9);
}

TEST(Movements, AlignedScopesStandUpright) {
  const auto derivation = derived("Lot --> r(10, 20, 30) alignScopeToAxes(y) X");
  EXPECT_EQ(derivation.terminals[0].scope.axis[1], (Vec3{0, 0, 1}));
}

TEST(Movements, PopBringsBackWhatWasPushed) {
  const auto derivation = derived("Lot --> [ t(1, 0, 0) A ] B");
  EXPECT_EQ(named(derivation, "A")[0]->scope.origin.x, 1);
  EXPECT_EQ(named(derivation, "B")[0]->scope.origin.x, 0);
}

TEST(Movements, WhatLeavesTheWorldStays) {
  const auto derivation =
      derived("Lot --> t(1000000, 0, 0) A\nA --> s(1000000, 0, 1000000) B\nB --> t('1000000, 0, 0) C");
  ASSERT_EQ(derivation.warnings.size(), 1u);
  EXPECT_NE(derivation.warnings[0].message.find("out of the world"), std::string::npos);
}

// ---- insertions, materials, output

TEST(Insert, AnAssetFillsTheScope) {
  const auto derivation = derived("Lot --> s('1, 4, '1) i(\"tree.obj\") Tree");
  ASSERT_EQ(derivation.terminals.size(), 1u);
  EXPECT_EQ(derivation.terminals[0].asset, "tree.obj");
  EXPECT_TRUE(derivation.terminals[0].faces.empty());
  EXPECT_EQ(derivation.terminals[0].scope.size_m, (std::array<double, 3>{10, 4, 8}));
}

TEST(Looks, AreInheritedByNameAndNumber) {
  const auto derivation = derived(
      "Lot --> set(material.name, \"brick\") color(\"#ff8000\") set(material.roughness, 0.25) texture(\"b.png\") X\n"
      "X --> Y color(0, 0, 1) Z");
  const Appearance& y = derivation.appearances[named(derivation, "Y")[0]->appearance];
  EXPECT_EQ(y.name, "brick");
  EXPECT_EQ(y.colour_map, "b.png");
  EXPECT_EQ(y.red, 1);
  EXPECT_NEAR(y.green, 128 / 255.0, 1e-12);
  EXPECT_EQ(y.roughness, 0.25);
  EXPECT_EQ(derivation.appearances[named(derivation, "Z")[0]->appearance].blue, 1);
}

TEST(Looks, SayWhatIsNoColour) {
  EXPECT_EQ(first_warning("Lot --> color(\"red\")"), "test.cga:1:9: expected a colour as \"#rrggbb\"");
}

TEST(TextureFrames, MeasureFromTheScopesOrigin) {
  const auto derivation = derived("Lot --> extrude(4) comp(f) { front : tileUV(0, 2, 4) X | all : NIL }");
  const TextureProjection frame = derivation.terminals.at(0).texture.value();
  const Vec3 p{5, 0, 3};
  EXPECT_NEAR(dot(p - frame.origin, frame.u_per_m), 2.5, 1e-12);
  EXPECT_NEAR(dot(p - frame.origin, frame.v_per_m), 0.75, 1e-12);
}

TEST(TextureFrames, ProjectionsLieOnTheSurfaceOnceProjected) {
  EXPECT_FALSE(derived("Lot --> setupProjection(0, scope.xz, 2, 2) X").terminals[0].texture);
  EXPECT_TRUE(derived("Lot --> setupProjection(0, scope.xz, '0.5, 2) projectUV(0) X").terminals[0].texture);
  EXPECT_NE(first_warning("Lot --> projectUV(0)"), "");
}

TEST(Words, ReportsAndLinesReachTheCaller) {
  const auto derivation = derived("Lot --> split(x) { { ~2 : report(\"windows\", 1) W }* } print(\"done\", 3)");
  EXPECT_EQ(derivation.reports.size(), 5u);
  EXPECT_EQ(derivation.printed, (std::vector<std::string>{"done 3"}));
}

TEST(OperationTable, NamesAreUnique) {
  std::set<std::string> names;
  EXPECT_GT(operation_table().size(), 30u);
  for (const OperationRow& row : operation_table()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

}  // namespace
}  // namespace citykiln::grammars
