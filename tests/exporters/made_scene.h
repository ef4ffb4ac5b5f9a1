// Small scenes of random objects that use every field of the recipes, for tests of writers and readers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "compiler/contract/erase_repeated.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/plane/smooth_land.h"
#include "compiler/scene/scene.h"

namespace citykiln::exporters {

/// Makes a random scene from a seed, the same on every machine.
class SceneMaker {
 public:
  explicit SceneMaker(std::uint64_t seed) : dice_(seed) {}

  /// @param finest_m  Step of the points' coordinates.
  scene::Chunk chunk(scene::TileKey tile, double finest_m) {
    finest_m_ = finest_m;
    scene::Chunk c;
    c.tile = tile, c.heights = field();
    for (auto i = below(4); i > 0; --i) c.surfaces.push_back(ground_surface());
    for (auto i = below(4); i > 0; --i) c.roads.push_back(road());
    for (auto i = below(3); i > 0; --i) c.junctions.push_back(junction());
    for (auto i = below(2); i > 0; --i)
      c.watercourses.push_back(
          {id(), line(), surface(), metres(20), metres(20), profile(), metres(99), below(9) * 16.0});
    for (auto i = below(3); i > 0; --i) c.bridges.push_back(span());
    for (auto i = below(2); i > 0; --i) c.tunnels.push_back(span());
    for (auto i = below(4); i > 0; --i) c.buildings.push_back(building());
    for (auto i = below(5); i > 0; --i) c.trees.push_back({id(), point(), metres(30), species_mix()});
    for (auto i = below(2); i > 0; --i) c.woods.push_back({id(), species_mix(), hectare(), eighths(200)});
    for (auto i = below(3); i > 0; --i)
      c.plantings.push_back(
          {id(), species_mix(), static_cast<std::uint8_t>(below(256)), eighths(40), eighths(40), eighths(20)});
    for (auto i = below(3); i > 0; --i) c.tree_rows.push_back({id(), line(), species_mix(), eighths(90), eighths(90)});
    for (auto i = below(2); i > 0; --i) c.corridors.push_back({id(), line(), eighths(300)});
    for (auto i = below(3); i > 0; --i)
      c.barriers.push_back(
          {id(), line(), static_cast<map::BarrierKind>(below(map::kBarrierKinds)), metres(3), metres(1)});
    for (auto i = below(3); i > 0; --i) c.lamps.push_back({id(), point(), metres(9), lamp_tags()});
    for (auto i = below(5); i > 0; --i) c.things.push_back(thing());
    for (auto i = below(3); i > 0; --i) c.wire_spans.push_back(wire_span());
    for (auto i = below(3); i > 0; --i) {
      const Vec2 from = point();
      c.pitches.push_back({id(), pick(pitches::PitchKind::kCount), from, from + Vec2{90, 8}, metres(70) + kQuantum_m});
    }
    for (auto i = below(3); i > 0; --i)
      c.landforms.push_back({{id(), line(), surface(), metres(20), metres(20), profile(), metres(99), 0},
                             pick(ground::LandformKind::kCount)});
    c.texts = texts();
    for (auto i = below(4); i > 0; --i) c.yards.push_back(yard(c.buildings));
    return c;
  }

  // A yard whose points, which may coincide, lie within 300 m of a place.
  lots::Yard yard(const std::vector<buildings::Building>& buildings) {
    const Vec2 place{static_cast<double>(below(2000)), static_cast<double>(below(2000))};
    const auto ring = [&] {
      Ring all;
      for (auto i = 3 + below(5); i > 0; --i)
        all.push_back(place + Vec2{below(1200) * lots::kOutlineStep_m, below(1200) * lots::kOutlineStep_m});
      return all;
    };
    const auto in_frame = [&] {
      return Vec2{below(900) * lots::kYardStep_m - 40, below(900) * lots::kYardStep_m - 40};
    };
    lots::Yard yard{.building = buildings.empty() || below(3) == 0
                                    ? id()
                                    : buildings[below(static_cast<std::uint32_t>(buildings.size()))].id,
                    .country = pick(map::CountryGroup::kCount),
                    .kind = pick(lots::LotKind::kCount),
                    .is_arid = below(2) == 0,
                    .polygon = {ring(), {}},
                    .frame = {place + in_frame(), static_cast<std::uint16_t>(below(lots::kHeadings))},
                    .setback_m = eighths(200),
                    .has_bays = below(2) == 0};
    if (below(3) == 0) yard.polygon.holes = {ring(), ring()};
    for (auto i = below(4); i > 0; --i) yard.strips.push_back({below(2) == 0, in_frame(), in_frame()});
    for (auto i = below(4); i > 0; --i)
      yard.borders.push_back({below(900), 1 + below(90), pick(lots::BorderPlace::kCount)});
    for (auto i = below(40); i > 0; --i) yard.plants.push_back(below(2) == 0);
    // values beyond the last are false
    if (!yard.plants.empty()) yard.plants.back() = true;
    return yard;
  }

  things::Thing thing() {
    things::Form form{.kind = below(2) == 0 ? "bench" : "sign",
                      .width_m = metres(3) + kQuantum_m,
                      .depth_m = metres(3) + kQuantum_m,
                      .height_m = metres(9) + kQuantum_m,
                      .value = below(2) == 0 ? "" : "bench;shelter",
                      .material = below(2) == 0 ? "" : "wood",
                      .text = below(2) == 0 ? "" : "50",
                      .capacity = static_cast<std::uint16_t>(below(1000)),
                      .country = pick(map::CountryGroup::kCount),
                      .variant = static_cast<std::uint8_t>(below(things::kVariants))};
    if (below(2) == 0)
      form.colour = map::Srgb{static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)), 255};
    return {id(), point(), static_cast<std::uint16_t>(below(things::kDirections)), below(2) == 0, form};
  }

  wires::WireSpan wire_span() {
    wires::WireSpan span{id(), 1.0 + static_cast<double>(below(80)), {}};
    const auto place = [&] { return Vec3{coarse(), coarse(), coarse()}; };
    for (auto i = 1 + below(7); i > 0; --i)
      span.wires.push_back({place(), place(), static_cast<double>(below(2000)) * wires::kWireQuantum_m,
                            static_cast<std::uint8_t>(1 + below(40)), pick(wires::WireKind::kCount)});
    return span;
  }
  double coarse() { return (static_cast<double>(below(200'000)) - 100'000) * wires::kWireQuantum_m; }

  map::LampTags lamp_tags() {
    if (below(2) == 0) return {};
    return {.type = pick(map::LampType::kCount),
            .mount = pick(map::LampMount::kCount),
            .count = static_cast<std::uint8_t>(1 + below(4)),
            .temperature_k = static_cast<std::uint16_t>(below(6000)),
            .lumen = static_cast<std::uint32_t>(below(20000))};
  }

  /// Returns two tiles side by side, one of coarse points, one of fine ones.
  scene::Scene scene() {
    scene::Header h;
    h.origin = {7.25, 43.5}, h.extent = {{-128, 0}, {128, 128}}, h.tile_m = 128, h.seed = dice_();
    h.resampling_error_m = 0.125;
    h.sky = {*sky::parse_time("2024-06-21T12:00:00Z"), {0.6, 0, 0.8}, 2.6};
    h.sky.to_sun = {629146 * 0x1p-20, 0, 838861 * 0x1p-20};
    h.sky.ground_m = 412;
    h.sky.clouds = {{sky::CloudKind::kCumulus, 0.4, 1500, 2300, {3, -4}, 7},
                    {sky::CloudKind::kCirrus, 1, 8000, 8100, {}, 0}};
    if (h.seed % 2 == 0) h.snow_line_m = 2200.5;
    h.has_wild_slopes = h.seed % 3 != 0;
    h.cars = h.seed % 5 == 0 ? cars::kNoCars : h.seed % 5 == 1 ? cars::CarShare{.share = 0.5} : cars::kUsualCars;
    h.has_street_furniture = h.seed % 2 == 1;
    h.people = h.seed % 3 == 0   ? people::kNobody
               : h.seed % 3 == 1 ? people::PeopleShare{.share = 0.25}
                                 : people::kUsualPeople;
    h.traffic = h.seed % 4 == 0 ? cars::CarShare{.share = 0.125} : h.seed % 4 == 1 ? cars::kUsualCars : cars::kNoCars;
    if (h.seed % 4 < 2) h.around = surroundings();
    if (h.seed % 3 < 2) h.shown = shown();
    if (h.seed % 5 < 2) h.clip = clip();
    h.rules = {{"house.cga", "Building --> Wall."}, {"parts/door.cga", "Door --> NIL\n"}};
    if (h.seed % 3 < 2) h.things = {{"bench", "bench amenity=bench"}, {"bench.cga", "Thing --> Seat."}};
    h.species = {{"oak", "n: 1\naxiom: F\n"}, {"reed", ""}};
    h.sources = {"town.osm", "hills.tif"}, h.attributions = {"© OpenStreetMap contributors"};
    return {h, {chunk({-1, 0}, 0x1p-7), chunk({0, 0}, kQuantum_m)}};
  }

 private:
  static constexpr double kQuantum_m = 0x1p-10;

  scene::Shown shown() {
    scene::Shown shown{.left_out = static_cast<scene::SceneLayers>(below(256)),
                       .wood_density = static_cast<double>(below(4097)) * scene::kWoodDensityStep,
                       .lamps = static_cast<scene::LampLight>(below(3))};
    if (below(2) == 0) shown.lit_windows = static_cast<double>(below(1025)) * scene::kLitWindowsStep;
    return shown;
  }

  /// Returns two squares, one with up to two holes.
  scene::Clip clip() {
    const auto square = [](Vec2 at, double side_m) {
      return Ring{at, at + Vec2{side_m, 0}, at + Vec2{side_m, side_m}, at + Vec2{0, side_m}};
    };
    scene::Clip clip = {{square({-128, 0}, 100 + static_cast<double>(below(20))), {}}, {square({0, 0}, 64), {}}};
    for (auto i = below(3); i > 0; --i)
      clip.front().holes.push_back(square({-120.0 + 30 * static_cast<double>(i), 8}, 16 + 0x1p-7));
    return clip;
  }

  surroundings::Surroundings surroundings() {
    surroundings::Surroundings around{.x_m = {-300, -128, 0, 128, 400},
                                      .y_m = {-90, 0, 128},
                                      .heights_m = {},
                                      .covers = {},
                                      .error_m = 41,
                                      .rms_error_m = 7};
    for (int i = 0; i < 15; ++i) {
      const bool is_sea = below(3) == 0;
      around.heights_m.push_back(is_sea ? 0 : static_cast<std::int32_t>(below(3000)) - 100);
      around.covers.push_back(is_sea          ? surroundings::Cover::kSea
                              : below(4) == 0 ? surroundings::Cover::kLake
                                              : surroundings::Cover::kLand);
    }
    return around;
  }

  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(dice_() % count); }
  plants::SpeciesMix species_mix() {
    return below(2) == 0 ? plants::species_mix_of(pick(plants::Species::kCount))
                         : plants::species_mix_of(pick(plants::PlantCommunity::kCount));
  }
  std::uint16_t hectare() { return static_cast<std::uint16_t>(1 + below(300)); }
  double eighths(std::uint32_t most) { return (2 + below(most)) / 8.0; }
  std::uint32_t number(std::uint32_t most) { return below(most); }
  template <typename Enum>
  Enum pick(Enum count) {
    return static_cast<Enum>(below(static_cast<std::uint32_t>(count)));
  }
  roads::Junction junction() {
    roads::Junction j{pick(roads::Family::kOther), {point()}, {}};
    for (auto i = 1 + below(5); i > 0; --i) j.cuts.push_back({below(256) / 4.0, below(61) / 4.0});
    return j;
  }
  map::LandCoverClass surface() { return pick(map::LandCoverClass::kCount); }
  double metres(std::uint32_t most) { return (1 + below(most * 1024)) * kQuantum_m; }
  double coordinate() { return (static_cast<double>(below(1u << 20)) - (1 << 19)) * finest_m_; }
  // a third of all points repeat an earlier one, as shared borders do
  Vec2 point() {
    if (!points_.empty() && below(3) == 0) return points_[below(static_cast<std::uint32_t>(points_.size()))];
    return points_.emplace_back(Vec2{coordinate(), coordinate()});
  }
  ObjectId id() {
    const auto number = static_cast<std::int64_t>(dice_() >> below(64));
    return {{static_cast<OsmType>(below(4)), below(2) == 0 ? number : -1 - number}, below(3)};
  }
  // sorted, as they are in a chunk; some share a name
  std::vector<map::ElementText> texts() {
    std::vector<map::ElementText> made;
    const std::string names[] = {"", "Rue de la Paix", "Ω «日本»", "Rue de la Paix 2"};
    for (auto i = below(9); i > 0; --i)
      if (const OsmId of = id().osm; of != OsmId{})
        made.push_back(
            {of, names[below(4)], below(3) == 0 ? map::TagList{{"name", "\"é\"\n"}, {"ref", ""}} : map::TagList{}});
    std::ranges::sort(made, {}, &map::ElementText::id);
    erase_repeated(made, &map::ElementText::id);
    return made;
  }
  std::vector<Vec2> line() {
    std::vector<Vec2> points;
    for (auto i = 2 + below(4); i > 0; --i) points.push_back(point());
    return points;
  }
  Ring ring() {
    Ring r = line();
    r.push_back(point());
    return r;
  }
  structures::SpanEnd span_end() {
    using structures::EndKind;
    structures::SpanEnd end{pick(EndKind::kCount), {}, 0};
    if (end.kind == EndKind::kGround || end.kind == EndKind::kJoint) end.beyond = point();
    if (end.kind == EndKind::kBesideRoad) end.cut_m = below(256) / 4.0;
    return end;
  }
  std::vector<structures::ParapetGap> openings() {
    std::vector<structures::ParapetGap> made;
    double at_m = 0;
    for (auto i = below(3); i > 0; --i) {
      const double from_m = at_m + below(999) / 4.0;
      made.push_back({from_m, at_m = from_m + (1 + below(99)) / 4.0});
    }
    return made;
  }
  structures::Plate plate() {
    structures::Plate made{id().osm, pick(map::LandCoverClass::kCount), {}};
    for (auto i = 1 + below(2); i > 0; --i) {
      structures::PlatePart& part = made.parts.emplace_back(structures::PlatePart{{}, below(2) == 0});
      for (auto r = 1 + below(2); r > 0; --r)
        for (auto c = 3 + below(4), first = c; c > 0; --c) {
          if (c == first) part.rings.emplace_back();
          const Vec2 at = point();
          part.rings.back().push_back({{at.x, at.y, static_cast<double>(below(999)) / 128}, below(2) == 0});
        }
    }
    return made;
  }
  structures::Span span() {
    structures::Span s{road(), span_end(), span_end(), {}, openings(), openings(), below(2) == 0};
    s.layer = static_cast<std::int8_t>(static_cast<int>(below(21)) - 10);
    s.deck = pick(structures::DeckForm::kCount);
    for (auto i = below(2); i > 0; --i) s.plates.push_back(plate());
    s.width_limits = {}, s.riser_m = 0, s.handrails = 0, s.cuttings = {};
    double at_m = 0;
    for (auto i = below(4); i > 0; --i)
      s.piers.push_back({at_m += (1 + below(999)) / 4.0, (static_cast<double>(below(9000)) - 400) / 4});
    return s;
  }
  ground::LandCoverPolygon ground_surface() {
    ground::LandCoverPolygon s{id(), surface(), number(90000), {ring(), ring()}};
    if (below(3) == 0) s.level_m = (static_cast<double>(below(9000)) - 400) * kProfileQuantum_m;
    s.is_graded = below(4) == 0;
    return s;
  }
  Profile profile() {
    Profile knots;
    double at_m = below(3);
    for (auto i = below(5); i > 0; --i) {
      knots.push_back({at_m, (static_cast<double>(below(90000)) - 900) * kProfileQuantum_m, 0});
      if (below(3) == 0) knots.back().tilt = (static_cast<double>(below(99)) - 50) * kTiltQuantum;
      at_m += (1 + below(999)) / 8.0;
    }
    return knots;
  }
  roads::Road road() {
    roads::Road r;
    r.id = id(), r.axis = line(), r.surface = surface(), r.section = section();
    r.side = static_cast<map::DrivingSide>(below(2)), r.is_lit = below(2) == 0, r.is_link = below(2) == 0,
    r.is_roundabout = below(2) == 0;
    r.country = pick(map::CountryGroup::kCount);
    r.assumed = static_cast<Assumptions>(below(kAllAssumptions + 1));
    r.assumed_sides = static_cast<std::uint8_t>(below(4));
    r.kerb_parking = static_cast<std::uint8_t>(below(4));
    if (below(3) == 0) r.start_along_m = metres(9000);
    for (auto i = below(3); i > 0; --i)
      r.points.push_back({below(2), pick(map::TrackPointKind::kCount), static_cast<std::int8_t>(below(3))});
    r.profile = profile();
    if (below(4) == 0) r.riser_m = metres(1), r.handrails = static_cast<std::uint8_t>(below(8));
    if (below(3) == 0) r.width_limits = {width_limits(), width_limits()};
    if (below(4) == 0) r.cuttings = cuttings();
    for (map::TrackPoint& p : r.points) {
      p.facing = static_cast<std::int8_t>(p.facing - 1);
      if (p.kind == map::TrackPointKind::kLevelCrossing) p.reach_quarters = static_cast<std::uint8_t>(below(256));
    }
    return r;
  }
  std::vector<roads::Cutting> cuttings() {
    std::vector<roads::Cutting> cuttings;
    double at_m = 0;
    for (auto i = 1 + below(2); i > 0; --i) {
      const double from_m = at_m + below(999) / 4.0;
      at_m = from_m + (1 + below(999)) / 4.0;
      cuttings.push_back({from_m, at_m});
    }
    return cuttings;
  }
  std::vector<roads::WidthLimit> width_limits() {
    std::vector<roads::WidthLimit> width_limits;
    double at_m = 0;
    for (auto i = below(4); i > 0; --i) {
      at_m += (1 + below(999)) / 4.0;
      width_limits.push_back({at_m, (1 + below(999)) / 32.0, !width_limits.empty() && below(2) == 0});
    }
    return width_limits;
  }
  map::CrossSection section() {
    map::CrossSection s;
    const std::uint32_t left = below(3), middle = 1 + below(4), right = below(3);
    for (std::uint32_t i = 0; i < left + middle + right; ++i) {
      const bool is_raised = i < left || i >= left + middle;
      s.lanes.push_back({pick(map::LaneKind::kCount), static_cast<map::LaneDirection>(below(3)), metres(5),
                         static_cast<std::uint16_t>(below(1024)), is_raised});
    }
    s.axis_offset_m = map::carriageway_width_m(s) * below(3) / 2;
    return s;
  }
  std::optional<map::Srgb> colour() {
    if (below(2) == 0) return std::nullopt;
    return map::Srgb{static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)), 255};
  }
  roofs::RoofShape roof_shape() {
    roofs::RoofShape roof{pick(roofs::RoofForm::kCount)};
    if (roof.form == roofs::RoofForm::kFlat) return roof;
    roof.height_m = metres(10), roof.overhang_m = metres(1);
    if (below(2) == 0) roof.direction = Vec2{metres(1), -metres(1)};
    roof.is_ridge_across = below(2) == 0;
    return roof;
  }
  std::vector<buildings::PartyWall> party_walls(std::size_t edges) {
    std::vector<buildings::PartyWall> walls;
    for (std::uint32_t edge = 0; edge < edges; ++edge)
      if (below(4) == 0) walls.push_back({edge, 0, 1 + metres(9), metres(60), below(2) == 0, below(2) == 0});
    return walls;
  }
  buildings::Passageway passageway() {
    const Vec2 from = point();
    return {id(), {from, from + Vec2{8, 4}}, 1 + metres(4), metres(4), metres(60), metres(4), metres(4)};
  }
  buildings::Building building() {
    buildings::Building b;
    b.id = id();
    b.footprint.outer = ring();
    for (auto i = below(3); i > 0; --i) b.footprint.holes.push_back(ring());
    b.bottom_m = metres(100), b.floor_m = b.bottom_m + metres(3);
    b.roof_shape = roof_shape();
    b.top_m = b.floor_m + 1 + metres(40) + b.roof_shape.height_m;
    b.stands_on_ground = below(2) == 0;
    b.wall = pick(materials::Material::kCount), b.roof = pick(materials::Material::kCount);
    b.wall_colour = colour(), b.roof_colour = colour();
    b.style = pick(buildings::Style::kCount);
    b.building_class = static_cast<std::uint8_t>(pick(map::BuildingClass::kCount));
    b.levels = static_cast<std::uint8_t>(1 + below(255));
    b.year = static_cast<std::uint16_t>(below(2030));
    b.has_shop = below(2) == 0;
    b.country = pick(map::CountryGroup::kCount);
    b.assumed = static_cast<Assumptions>(below(kAllAssumptions + 1));
    for (std::size_t i = 0; i < b.footprint.outer.size(); ++i)
      b.facade_edges.push_back(
          {below(2) == 0, static_cast<std::uint8_t>(below(256)), static_cast<std::uint16_t>(below(65536))});
    b.party_walls = party_walls(b.footprint.outer.size());
    for (auto i = below(3); i > 0; --i) b.passageways.push_back(passageway());
    for (auto i = below(3); i > 0; --i) b.fronts.push_back(front(b.footprint.outer.size()));
    return b;
  }
  buildings::Front front(std::size_t edges) {
    const double from_m = below(400) * buildings::kFrontStep_m;
    buildings::Front f{.edge = below(static_cast<std::uint32_t>(edges)),
                       .from_m = from_m,
                       .to_m = from_m + (1 + below(90)) * buildings::kFrontStep_m,
                       .kind = pick(map::FrontKind::kCount)};
    f.is_assumed = below(2) == 0;
    if (below(2) == 0) f.hours.emplace();
    if (f.hours)
      for (std::uint8_t& quarter : f.hours->quarters) quarter = static_cast<std::uint8_t>(below(121));
    return f;
  }
  map::Heightfield field() {
    const Vec2 step_m{1 + below(1000) * map::kStepUnit_m, 1 + below(1000) * map::kStepUnit_m};
    map::Heightfield h{step_m * -1.0, step_m, 4, 5, {}, below(9) * kQuantum_m};
    const std::uint32_t grain = below(5);
    for (int i = 0; i < 20; ++i) h.heights.push_back(static_cast<std::int32_t>(below(9000) << grain) - 30000 * 64);
    return map::smooth_land(std::move(h), 1 << below(3));
  }

  std::mt19937_64 dice_;
  double finest_m_ = kQuantum_m;
  std::vector<Vec2> points_;
};

}  // namespace citykiln::exporters
