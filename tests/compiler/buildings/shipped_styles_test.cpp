// Properties of every style in grammars/rules on any mass model.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "compiler/buildings/meshes/terminal_meshes.h"
#include "grammars/derivation/form_roofs.h"
#include "grammars/language/read_rules.h"
#include "tests/grammars/made_mass.h"
#include "tests/grammars/rule_files.h"

namespace citykiln::buildings {
namespace {

using namespace grammars;

/// A style, a mass that it is commonly given, and what it may make of it.
struct ShippedStyle {
  const char* name;
  double width_m, depth_m, height_m, levels;
  const char* roof;
  std::size_t most_triangles;
  double most_out_m, most_up_m;  ///< Out of the walls, over the highest point of the mass.
};

constexpr ShippedStyle kStyles[] = {
    {"old_town_house", 9, 10, 13, 4, "gabled", 5500, 0.55, 1.95},
    {"courtyard_block", 24, 20, 19, 5, "flat", 16000, 1.15, 2.6},
    {"row_house", 6, 9, 6, 2, "gabled", 1600, 0.85, 1.95},
    {"villa", 11, 9, 5.6, 2, "hipped", 2200, 1.15, 1.95},
    {"panel_block", 45, 12, 16.8, 6, "flat", 17000, 1.45, 2.6},
    {"office_slab", 32, 14, 22, 6, "flat", 12000, 0.25, 2.6},
    {"glass_tower", 26, 26, 110, 30, "flat", 15000, 0.3, 2.6},
    {"shop", 22, 16, 4.5, 1, "flat", 1300, 1.65, 2.6},
    {"warehouse", 36, 24, 8, 1, "gabled", 5000, 0.55, 1.6},
    {"church", 12, 26, 10, 1, "gabled", 2600, 0.85, 1.6},
    {"barn", 18, 10, 4.5, 1, "gabled", 1100, 0.55, 1.6},
    {"garage", 12, 6, 2.6, 1, "flat", 450, 0.1, 0.2},
    {"castle", 14, 14, 16, 4, "flat", 3000, 0.35, 1.3},
    {"north_american_house", 12, 9, 5.6, 2, "gabled", 2900, 1.8, 1.95},
    {"north_american_row", 12, 12, 11, 3, "flat", 5000, 1.9, 2.6},
    {"japanese_house", 9, 8, 5.8, 2, "gabled", 1700, 1.15, 0.5},
    {"japanese_apartments", 24, 11, 14.5, 5, "flat", 15000, 1.35, 2.6},
    {"british_terrace", 10.4, 8, 5.4, 2, "gabled", 2600, 0.75, 2.45},
    {"mediterranean_house", 9, 9, 9.4, 3, "gabled", 3500, 0.85, 1.95},
    {"balcony_flats", 13, 10, 12.6, 4, "flat", 7000, 1.35, 2.6},
    {"nordic_wood", 10, 8, 5.6, 2, "gabled", 2900, 1.6, 1.95},
    {"latin_american_house", 8, 9, 6.2, 2, "flat", 1800, 1.0, 2.6},
    {"flat_roof_house", 9, 9, 6.2, 2, "flat", 1700, 1.25, 2.6},
    {"tropical_house", 10, 8, 3.2, 1, "hipped", 1300, 2.2, 0.5},
    {"south_asian_house", 8, 10, 9.3, 3, "flat", 4200, 1.15, 2.6},
    {"chinese_slab", 22, 11, 16.8, 6, "flat", 9000, 1.25, 2.6},
    {"tower_1960", 36, 16, 48, 15, "flat", 18000, 1.3, 2.6},
    {"tower_1990", 28, 26, 70, 19, "flat", 21000, 0.5, 2.6},
    {"tower_2015", 28, 26, 70, 20, "flat", 13000, 1.4, 2.6},
    {"haussmann", 18, 13, 19, 6, "gambrel", 10500, 0.75, 1.95},
    {"gruenderzeit", 18, 13, 16.5, 5, "gabled", 8500, 0.95, 1.95},
    {"asian_midrise", 9, 13, 20, 6, "flat", 4500, 0.95, 2.6},
};

void PrintTo(const ShippedStyle& style, std::ostream* out) { *out << style.name; }

struct ShippedStyles : testing::TestWithParam<ShippedStyle> {
  Result<Program> program = read_rules(std::string(GetParam().name) + ".cga", shipped);

  void SetUp() override { ASSERT_TRUE(program) << to_string(program.error()); }

  Derivation derive_on(const MadeMass& made, double levels, std::map<std::string, Value> attributes = {},
                       double tolerance_m = 0) const {
    roofs::RoofForm became{};
    const Shape mass = mass_model_of(made, &became);
    DeriveOptions options;
    options.attributes = std::move(attributes);
    options.attributes["height"] = made.height_m, options.attributes["levels"] = levels;
    options.attributes["roof"] = std::string(name_of(became));
    // the options that the compiler uses
    options.tolerance_m = tolerance_m, options.keep_appearances = tolerance_m < 0.5, options.prune_early = true;
    options.roofs = form_roofs(0.02);
    return derive(*program, mass, options);
  }
};

MadeMass made_of(const ShippedStyle& style) {
  MadeMass made;
  made.footprint = {{{0, 0}, {style.width_m, 0}, {style.width_m, style.depth_m}, {0, style.depth_m}}, {}};
  made.height_m = style.height_m;
  made.roof.form = *roofs::form_named(style.roof);
  made.roof.overhang_m = made.roof.form == roofs::RoofForm::kFlat ? 0 : 0.4;
  return made;
}

std::size_t triangles_of(const Derivation& derivation) {
  std::size_t sum = 0;
  for (const auto& part : terminal_meshes(derivation, {}, 0)) sum += part.mesh.triangles.size();
  return sum;
}

Polygon rectangle_outline(double w, double d) { return {{{0, 0}, {w, 0}, {w, d}, {0, d}}, {}}; }

const Polygon kPlans[] = {
    rectangle_outline(12, 10),
    {{{0, 0}, {14, 0}, {14, 6}, {6, 6}, {6, 12}, {0, 12}}, {}},
    {{{0, 0}, {30, 0}, {30, 26}, {0, 26}}, {{{9, 9}, {9, 17}, {21, 17}, {21, 9}}}},
    rectangle_outline(0.5, 9),
    rectangle_outline(0.5, 0.5),
    {{{0, 0}, {9, 1}, {4, 7}}, {}},
    rectangle_outline(60, 40),
};

// From smaller than a building to a district.
constexpr std::pair<double, const char*> kRoofed[] = {{0.5, "flat"}, {2.5, "flat"},  {2.5, "gabled"}, {7, "hipped"},
                                                      {7, "gabled"}, {7, "mansard"}, {40, "flat"},    {40, "dome"}};

TEST_P(ShippedStyles, HaveNoTroubleOnAnyMass) {
  bool shop = false;
  for (const Polygon& plan : kPlans)
    for (const auto& [height_m, roof] : kRoofed) {
      MadeMass made{plan, {0, 1}, {2}, {}, height_m, StableId{static_cast<std::uint64_t>(height_m * 8)}};
      made.roof.form = *roofs::form_named(roof);
      const Derivation derivation = derive_on(made, std::max(1.0, height_m / 3), {{"shop", shop = !shop}});
      EXPECT_FALSE(derivation.terminals.empty());
      EXPECT_TRUE(derivation.limits.empty()) << roof << " " << height_m;
      for (const Warning& warning : derivation.warnings) ADD_FAILURE() << warning_line(*program, warning);
    }
}

TEST_P(ShippedStyles, AreNotMuchMoreThanTheyShow) {
  for (std::uint64_t id = 1; id <= 12; ++id) {
    MadeMass made = made_of(GetParam());
    made.id = StableId{id};
    for (const bool shop : {false, true}) {
      const std::size_t triangles = triangles_of(derive_on(made, GetParam().levels, {{"shop", shop}}));
      EXPECT_GT(triangles, 0u);
      EXPECT_LE(triangles, GetParam().most_triangles);
    }
  }
}

TEST_P(ShippedStyles, StandOutAsFarAsTheyMay) {
  for (std::uint64_t id = 1; id <= 12; ++id) {
    MadeMass made = made_of(GetParam());
    made.id = StableId{id};
    double top_m = 0;
    for (const Face& face : mass_model_of(made).faces) each_vertex(face, [&](Vec3 p) { top_m = std::max(top_m, p.z); });
    double out_m = 0, up_m = 0;
    for (const Terminal& terminal : derive_on(made, GetParam().levels, {{"shop", true}}).terminals)
      for (const Face& face : terminal.faces)
        each_vertex(face, [&](Vec3 p) {
          out_m = std::max({out_m, -p.x, -p.y, p.x - GetParam().width_m, p.y - GetParam().depth_m});
          up_m = std::max(up_m, p.z - top_m);
        });
    EXPECT_GT(top_m, 0);
    EXPECT_LE(out_m, GetParam().most_out_m + 1e-9);
    EXPECT_LE(up_m, GetParam().most_up_m + 1e-9);
  }
}

// Prints the rows of grammars/rules/README.md.
TEST_P(ShippedStyles, LoseTrianglesWithTheToleranceAndSayHowFar) {
  const MadeMass made = made_of(GetParam());
  std::printf("| %s", GetParam().name);
  std::size_t before = ~std::size_t{0};
  for (const double tolerance_m : {0.0, 0.02, 0.1, 0.5, 2.5, 12.5}) {
    const Derivation derivation = derive_on(made, GetParam().levels, {}, tolerance_m);
    EXPECT_LE(derivation.error_m, tolerance_m);
    const std::size_t triangles = triangles_of(derivation);
    EXPECT_GT(triangles, 0u) << tolerance_m;
    EXPECT_LE(triangles, before) << tolerance_m;
    std::printf(" | %zu at %g m", before = triangles, tolerance_m);
  }
  std::printf(" |\n");
}

// Widths of the horizontal faces of window reveals, in millimetres.
std::set<std::int64_t> window_widths_mm(const Derivation& derivation) {
  std::set<std::int64_t> widths_mm;
  for (const Terminal& terminal : derivation.terminals) {
    if (terminal.name != "Reveal" || path_name(derivation, terminal.path).find("/Window/") == std::string::npos)
      continue;
    const auto size_m = scope_around(terminal.faces, axes_of(terminal.faces.front()), {}).size_m;
    if (std::abs(normal_of(terminal.faces.front()).z) > 0.9)
      widths_mm.insert(std::llround(std::max(size_m[0], size_m[1]) * 1000));
  }
  return widths_mm;
}

TEST_P(ShippedStyles, CutNoWindowAtAWallsEnd) {
  ShippedStyle style = GetParam();
  style.roof = "flat";
  std::set<std::int64_t> widths_mm;
  for (style.width_m = 2; style.width_m < 32; style.width_m += 0.73) {
    const auto of_this = window_widths_mm(derive_on(made_of(style), style.levels, {{"balcony_every", 0.0}}));
    widths_mm.insert(of_this.begin(), of_this.end());
  }
  // as many widths as the style has windows, for all lengths of walls
  EXPECT_LE(widths_mm.size(), 5u);
  EXPECT_TRUE(widths_mm.empty() || *widths_mm.begin() >= 800);
}

TEST_P(ShippedStyles, GiveNeighboursDifferentWalls) {
  std::set<std::array<double, 3>> colours;
  for (std::uint64_t id = 1; id <= 24; ++id) {
    MadeMass made = made_of(GetParam());
    made.id = StableId{id};
    const Derivation derivation = derive_on(made, GetParam().levels);
    std::map<std::uint32_t, double> area_m2_of;
    for (const Terminal& terminal : derivation.terminals)
      for (const Face& face : terminal.faces) area_m2_of[terminal.appearance] += area_m2(face);
    std::array<double, 3> most{};
    double most_m2 = 0;
    for (const auto& [look, m2] : area_m2_of)
      if (m2 > most_m2) {
        most_m2 = m2;
        const Appearance& l = derivation.appearances[look];
        most = {l.red, l.green, l.blue};
      }
    colours.insert(most);
  }
  EXPECT_GT(colours.size(), 2u);
}

// Colours too light for the material would be paint without texture.
TEST_P(ShippedStyles, DrawColoursThatTheirMaterialsCanShow) {
  for (std::uint64_t id = 1; id <= 24; ++id) {
    MadeMass made = made_of(GetParam());
    made.id = StableId{id};
    for (const Appearance& look : derive_on(made, GetParam().levels).appearances)
      for (const char* name : {"stone", "roof_tile", "slate", "concrete"})
        if (look.name == name) {
          EXPECT_EQ(surface_material_of(look).material, materials::material_named(name))
              << look.red << " " << look.green;
        }
  }
}

TEST_P(ShippedStyles, WearTheTaggedColours) {
  const Derivation derivation =
      derive_on(made_of(GetParam()), GetParam().levels,
                {{"wall_colour", std::string("#123456")}, {"roof_colour", std::string("#654321")}});
  const auto has = [&](double red) {
    return std::any_of(derivation.appearances.begin(), derivation.appearances.end(),
                       [&](const Appearance& look) { return std::abs(look.red - red / 255) < 1e-9; });
  };
  EXPECT_TRUE(has(0x12));
  EXPECT_TRUE(has(0x65));
}

// The largest setback of a tower's upper end from its lower end, over some ids.
double stands_back_m(const Program& program, double height_m, bool attached) {
  double most_m = 0;
  for (std::uint64_t id = 1; id <= 12; ++id) {
    MadeMass made = made_of({"glass_tower", 26, 26, height_m, 30, "flat", 0, 0, 0});
    made.id = StableId{id};
    DeriveOptions options;
    options.attributes = {{"height", height_m}, {"levels", height_m / 3.6}, {"attached", attached}};
    double top_low_x = 26;
    for (const Terminal& terminal : derive(program, mass_model_of(made), options).terminals)
      for (const Face& face : terminal.faces)
        each_vertex(face, [&](Vec3 p) {
          if (p.z > height_m) top_low_x = std::min(top_low_x, p.x);
        });
    most_m = std::max(most_m, top_low_x);
  }
  return most_m;
}

// A detached tower has a setback with a terrace; walls with a neighbour are straight.
TEST(GlassTower, StandsBackWhereItStandsAlone) {
  const Result<Program> program = read_rules("glass_tower.cga", shipped);
  ASSERT_TRUE(program);
  EXPECT_GT(stands_back_m(*program, 110, false), 2);
  EXPECT_LT(stands_back_m(*program, 110, true), 0.5);
  EXPECT_LT(stands_back_m(*program, 40, false), 0.5);
}

// ---- parts that styles share ----------------------------------------------------------------------------------------

// The number of faces of terminals whose path of rules has this part, such as "/Gutter/".
std::size_t count_below(const char* style, const MadeMass& made, std::map<std::string, Value> attributes,
                        const char* part, double tolerance_m = 0) {
  const Result<Program> program = read_rules(std::string(style) + ".cga", shipped);
  if (!program) return 0;
  roofs::RoofForm became{};
  const Shape mass = mass_model_of(made, &became);
  DeriveOptions options;
  options.attributes = std::move(attributes);
  options.attributes["height"] = made.height_m, options.attributes["roof"] = std::string(name_of(became));
  options.tolerance_m = tolerance_m, options.roofs = form_roofs(0.02);
  const Derivation derivation = derive(*program, mass, options);
  std::size_t faces = 0;
  for (const Terminal& terminal : derivation.terminals)
    if (path_name(derivation, terminal.path).find(part) != std::string::npos) faces += terminal.faces.size();
  return faces;
}

TEST(SharedParts, DrainSteepRoofsAndNoLevelOnes) {
  MadeMass house = made_of({"row_house", 8, 9, 6, 2, "gabled", 0, 0, 0});
  EXPECT_GT(count_below("row_house", house, {{"levels", 2.0}}, "/Gutter/"), 8u);
  EXPECT_GT(count_below("row_house", house, {{"levels", 2.0}}, "/Downpipe/"), 2u);
  EXPECT_EQ(count_below("row_house", house, {{"levels", 2.0}, {"lifted", true}}, "/Downpipe/"), 0u);
  // without eaves the gutter of a house between neighbours hangs on its wall
  house.roof.overhang_m = 0;
  EXPECT_EQ(count_below("row_house", house, {{"levels", 2.0}}, "/Gutter/"), 0u);
  EXPECT_GT(count_below("row_house", house, {{"levels", 2.0}, {"attached", true}}, "/Gutter/"), 4u);
  house.roof.form = roofs::RoofForm::kFlat;
  EXPECT_EQ(count_below("row_house", house, {{"levels", 2.0}, {"attached", true}}, "/Gutter/"), 0u);
}

TEST(SharedParts, HaveADoorEveryFewWindowsOfALongWall) {
  const auto doors = [](double width_m) {
    return count_below("balcony_flats", made_of({"balcony_flats", width_m, 10, 12.6, 4, "flat", 0, 0, 0}),
                       {{"levels", 4.0}}, "/DoorLeaf/");
  };
  EXPECT_GT(doors(14), 0u);
  EXPECT_GE(doors(70), 2 * doors(14));
}

// A part far smaller than the wall it is put on is not kept by levels that leave out a balcony.
TEST(SharedParts, LeaveOutSmallPartsAtCoarseLevels) {
  for (std::uint64_t id = 1; id <= 12; ++id) {
    MadeMass flats = made_of({"balcony_flats", 26, 10, 12.6, 4, "flat", 0, 0, 0});
    flats.id = StableId{id};
    const std::map<std::string, Value> given{{"levels", 4.0}, {"entrances", 0.0}};
    EXPECT_GT(count_below("balcony_flats", flats, given, "/Plate/"), 0u) << id;
    for (const char* part : {"/Plate/", "/Vent/", "/Plants/", "/Aerial/", "/Dish/"})
      EXPECT_EQ(count_below("balcony_flats", flats, given, part, 2.5), 0u) << part << id;
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShippedStyles, testing::ValuesIn(kStyles),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace citykiln::buildings
