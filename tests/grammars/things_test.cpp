// Tests of the rules in grammars/things: each on a box, for several countries and at several tolerances.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "grammars/language/read_rules.h"
#include "grammars/shapes/round_body.h"
#include "tests/grammars/derivation_claims.h"
#include "tests/grammars/rule_files.h"

namespace citykiln::grammars {
namespace {

std::vector<std::string> thing_files() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(source_file("grammars/things")))
    if (entry.path().extension() == ".cga") names.insert(entry.path().filename().string());
  return {names.begin(), names.end()};
}

Result<Program> thing_program(const std::string& file) {
  return read_rules(file, [](const std::string& name) { return text_of_tree("grammars/things/" + name); });
}

Shape thing_box(double width_m, double depth_m, double height_m) {
  Shape box;
  box.id = StableId{11};
  box.scope.axis = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  box.scope.size_m = {width_m, depth_m, height_m};
  box.faces = cylinder_in(box.scope, 2, 1, {.given = 4}).faces;
  box.parent_scope = box.scope;
  return box;
}

Derivation thing_at(const Program& program, const Shape& box, double tolerance_m, const std::string& country = "") {
  DeriveOptions options;
  options.tolerance_m = tolerance_m;
  options.keep_appearances = true;
  options.attributes = {{"country", country}, {"text", std::string("50")}};
  return derive(program, box, options);
}

std::size_t triangles_in(const Derivation& derivation) {
  std::size_t count = 0;
  for (const Terminal& terminal : derivation.terminals)
    for (const Face& face : terminal.faces) count += face.outer.size() < 3 ? 0 : face.outer.size() - 2;
  return count;
}

TEST(Things, ThereAreMoreThanAHundredRules) { EXPECT_GT(thing_files().size(), 100u); }

TEST(Things, EveryRuleDerivesWithoutWarnings) {
  for (const std::string& file : thing_files()) {
    const Result<Program> program = thing_program(file);
    ASSERT_TRUE(program) << to_string(program.error());
    const Shape box = thing_box(2, 1.5, 2.5);
    for (const char* country : {"", "north_america", "british_isles", "japan"}) {
      const Derivation made = thing_at(*program, box, 0, country);
      EXPECT_TRUE(made.warnings.empty()) << file << ": "
                                         << (made.warnings.empty() ? ""
                                                                   : warning_line(*program, made.warnings.front()));
      EXPECT_TRUE(made.limits.empty()) << file;
      EXPECT_FALSE(made.terminals.empty()) << file;
      EXPECT_TRUE(is_finite(made)) << file;
    }
  }
}

TEST(Things, CoarserThingsHaveFewerTrianglesAndStateTheirError) {
  std::size_t fine = 0, coarse = 0;
  for (const std::string& file : thing_files()) {
    const Result<Program> program = thing_program(file);
    ASSERT_TRUE(program);
    const Shape box = thing_box(2, 1.5, 2.5);
    std::size_t before = triangles_in(thing_at(*program, box, 0.02));
    fine += before;
    for (const double tolerance_m : {0.1, 0.5}) {
      const Derivation made = thing_at(*program, box, tolerance_m);
      EXPECT_LE(made.error_m, tolerance_m) << file;
      EXPECT_LE(10 * triangles_in(made), 11 * before) << file;
      before = triangles_in(made);
    }
    coarse += before;
  }
  EXPECT_LT(4 * coarse, 3 * fine);
}

TEST(Things, TheStatedErrorBoundsTheDistanceBetweenLevels) {
  std::uint32_t state = 5;
  const auto chance = [&] { return state = state * 1664525u + 1013904223u; };
  for (const char* file :
       {"bench.cga", "fire_hydrant.cga", "post_box.cga", "statue.cga", "goal.cga", "power_tower.cga"}) {
    const Result<Program> program = thing_program(file);
    ASSERT_TRUE(program);
    const Shape box = thing_box(2, 1.5, 2.5);
    const Derivation fine = thing_at(*program, box, 0);
    for (const double tolerance_m : {0.05, 0.2, 0.5}) {
      const Derivation coarse = thing_at(*program, box, tolerance_m);
      const auto a = triangles_of(fine), b = triangles_of(coarse);
      const double measured_m = std::max(sampled_m(a, b, 150, chance), sampled_m(b, a, 150, chance));
      EXPECT_LE(measured_m, coarse.error_m + fine.error_m + 1e-6) << file << " at " << tolerance_m;
    }
  }
}

TEST(Things, ThingsTurnedWithTheirBoxAreTheSame) {
  const Result<Program> program = thing_program("bench.cga");
  ASSERT_TRUE(program);
  Shape turned = thing_box(2, 1, 1);
  turned.scope.axis = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}};
  turned.faces = cylinder_in(turned.scope, 2, 1, {.given = 4}).faces;
  EXPECT_EQ(triangles_in(thing_at(*program, turned, 0)), triangles_in(thing_at(*program, thing_box(2, 1, 1), 0)));
}

}  // namespace
}  // namespace citykiln::grammars
