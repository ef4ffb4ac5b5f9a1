#include "compiler/commands/things_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>
#include <vector>

#include "compiler/bake/merge.h"
#include "compiler/commands/sheet.h"
#include "compiler/make_header.h"
#include "compiler/sky/plan.h"
#include "compiler/things/generate.h"
#include "preview/render.h"

namespace citykiln::commands {
namespace {

constexpr std::array kSheetTolerances_m = {0.02, 0.1, 0.5};
constexpr int kTolerances = static_cast<int>(kSheetTolerances_m.size());
constexpr int kThingPixels = 180, kThingsInRow = 4, kThingSamples = 24;

// The form of a row without tags.
things::Form default_form(const map::ThingRow& row) {
  const std::string value = row.tags.empty() ? "" : row.tags.front().front().value;
  return {.kind = row.name,
          .width_m = row.width.default_m,
          .depth_m = row.depth.default_m,
          .height_m = row.height.default_m,
          .value = value == "*" ? "" : value,
          .text = "30"};
}

bake::BakedTile tile_of_thing(const things::Form& form, const things::Kind& kind, double tolerance_m) {
  const things::GeneratedThing thing = things::generate(form, kind, 0, false, tolerance_m);
  bake::BakedTile tile;
  tile.features = {OsmId{}};
  tile.primitives = {ground_square(materials::Material::kPaving,
                                   static_cast<float>(20 * std::max({form.width_m, form.depth_m, form.height_m})))};
  if (!thing.meshes.empty())
    tile.instanced.push_back({.name = form.kind,
                              .primitives = bake::instanced_primitives(thing.meshes, bake::Layer::kProps),
                              .translations = {{0, 0, 0}},
                              .rotations = {{0, 0, 0, 1}},
                              .scales = {1},
                              .features = {0}});
  tile.textures = bake::textures_shown(tile, tolerance_m, materials::TextureCache(1));
  return tile;
}

// From in front of it, a little to the right.
preview::Camera camera_before(const things::Form& form) {
  const double size_m = length(Vec3{form.width_m, form.depth_m, form.height_m});
  const Vec3 middle{0, 0, form.height_m / 2};
  return {middle + unit(Vec3{0.5, -1, 0.25}) * (1.7 * size_m), middle, 38};
}

// The rows of the table with these names, in the order of the table; all of them if no name is given.
Result<std::vector<map::ThingRow>> rows_with(const std::vector<map::ThingRow>& table,
                                             const std::vector<std::string>& names) {
  if (names.empty()) return table;
  for (const std::string& name : names)
    if (std::ranges::find(table, name, &map::ThingRow::name) == table.end())
      return Error{"--kind", fmt::format("no row of the table of things is called \"{}\"", name)};
  std::vector<map::ThingRow> rows;
  std::ranges::copy_if(table, std::back_inserter(rows),
                       [&](const map::ThingRow& row) { return std::ranges::find(names, row.name) != names.end(); });
  return rows;
}

// Draws a thing at all tolerances, in the place of its number.
void draw_thing(const map::ThingRow& row, const things::Kind& kind, int number, const sky::Sky& sky,
                preview::Image& sheet) {
  preview::Options options;
  options.width = options.height = kThingPixels, options.samples = kThingSamples;
  const things::Form form = default_form(row);
  for (int k = 0; k < kTolerances; ++k) {
    const bake::BakedTile tile = tile_of_thing(form, kind, kSheetTolerances_m[static_cast<std::size_t>(k)]);
    put_picture(preview::render(std::span(&tile, 1), sky, camera_before(form), options),
                kThingPixels * (number % kThingsInRow * kTolerances + k), kThingPixels * (number / kThingsInRow),
                sheet);
  }
}

}  // namespace

Result<Done> draw_things_sheet(const ThingsSheet& asked, const Console& console) {
  CompileSpec spec;
  spec.things_folder = asked.folder;
  spec.cars = true;
  const Result<things::Catalogue> catalogue = read_things(spec);
  if (!catalogue) return catalogue.error();
  const Result<things::Kinds> kinds = things::kinds_of(*catalogue);
  if (!kinds) return kinds.error();
  const Result<std::vector<map::ThingRow>> drawn = rows_with(catalogue->table, asked.names);
  if (!drawn) return drawn.error();
  const Result<sky::Sky> sky = sky::plan({11, 48}, "2026-06-21T09:30");
  if (!sky) return sky.error();
  const int rows = (static_cast<int>(drawn->size()) + kThingsInRow - 1) / kThingsInRow;
  preview::Image sheet = empty_sheet(kThingPixels * kThingsInRow * kTolerances, kThingPixels * rows);
  std::vector<std::string> lines(static_cast<std::size_t>(rows));
  for (int i = 0; i < static_cast<int>(drawn->size()); ++i) {
    const map::ThingRow& row = (*drawn)[static_cast<std::size_t>(i)];
    lines[static_cast<std::size_t>(i / kThingsInRow)] += " " + row.name;
    draw_thing(row, kinds->at(row.name), i, *sky, sheet);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) console.print_line(fmt::format("row {}:{}", i + 1, lines[i]));
  return preview::write_image(sheet, asked.path);
}

}  // namespace citykiln::commands
