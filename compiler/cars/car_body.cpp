#include "compiler/cars/car_body.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "compiler/geometry/trig.h"

namespace citykiln::cars {
namespace {

// Rows of points of a section.
enum : std::size_t { kSill, kLower, kWidest, kShoulder, kBelt, kPaneFoot, kPaneHead, kRoofEdge, kRoofHalf, kMiddle };

// The radius of a wheel arch.
double arch_m(const CarShape& shape) { return 1.13 * shape.wheel_m + 0.02; }
constexpr double kWellDepth_m = 0.32;
constexpr int kArchParts = 6;
// The bottom of a shell without wheels.
constexpr double kOutlineFoot_m = 0.0625;

// A station of the sides below the windows. `arch` is 1 or 2 within a wheel arch, whose edge is `low_m`.
struct Station {
  double along_m = 0, low_m = 0;
  int arch = 0;
};

// Makes the shell of one car.
struct BodyMaker {
  const CarShape& shape;
  CarLevel level;
  const CarSurfaces& surfaces;
  Facets& facets;
  Sections sections = Sections(shape);
  double end_m = sections.keys().back();

  bool is_full() const { return level == CarLevel::kFull; }
  bool is_cab() const { return shape.body == "lorry"; }
  bool has_rear_window() const { return shape.body != "van" && !is_cab(); }

  Vec3 placed(Vec3 p) const { return {p.x, p.y - shape.length_m / 2, p.z}; }

  // ---- where sections are ---------------------------------------------------------------------------------------

  std::vector<double> coarse_places() const {
    const double c = shape.corner_m;
    if (level == CarLevel::kOutline)
      return {0, shape.screen_from_m, shape.screen_to_m, shape.windows.back(), shape.rear_from_m, end_m};
    return {0,
            0.75 * c,
            shape.screen_from_m,
            shape.screen_to_m,
            shape.windows.front(),
            shape.windows.back(),
            shape.rear_from_m,
            shape.rear_to_m,
            end_m - 0.6 * c,
            end_m};
  }

  static void tidy(std::vector<double>& places) {
    constexpr double kSame_m = 0.004;
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end(), [](double a, double b) { return b - a < kSame_m; }),
                 places.end());
  }

  std::vector<double> upper_places() const {
    std::vector<double> places = is_full() ? sections.keys() : coarse_places();
    if (is_full()) places.insert(places.end(), shape.windows.begin(), shape.windows.end());
    tidy(places);
    return places;
  }

  std::vector<Station> side_stations() const {
    std::vector<double> places = is_full() ? sections.side_keys() : coarse_places();
    if (is_full()) places.push_back(lamp_end_m()), places.push_back(end_m - tail_lamp_m());
    tidy(places);
    const double foot_m = level == CarLevel::kOutline ? kOutlineFoot_m : shape.sill_m;
    std::vector<Station> stations;
    for (const double along_m : places) stations.push_back({along_m, foot_m, 0});
    if (is_full()) add_arch(shape.front_axle_m, 1, stations), add_arch(shape.rear_axle_m, 2, stations);
    std::ranges::stable_sort(stations, {}, &Station::along_m);
    return stations;
  }

  void add_arch(double axle_m, int arch, std::vector<Station>& stations) const {
    const double radius_m = arch_m(shape), from_m = axle_m - radius_m, to_m = axle_m + radius_m;
    if (to_m > end_m) return;
    std::erase_if(stations, [&](const Station& s) { return s.along_m > from_m - 0.01 && s.along_m < to_m + 0.01; });
    stations.push_back({from_m, shape.sill_m, 0});
    for (int i = 0; i <= kArchParts; ++i) {
      const Vec2 turn = direction_of(0.5 * (kArchParts - i) / kArchParts);
      stations.push_back({axle_m + radius_m * turn.x, shape.wheel_m + radius_m * turn.y, arch});
    }
    stations.push_back({to_m, shape.sill_m, 0});
  }

  // ---- sides below the windows ----------------------------------------------------------------------------------

  // The place of a section at a height between sill and shoulder.
  static Vec3 on_side(const Section& section, double z) {
    for (std::size_t j = kSill; j < kShoulder; ++j)
      if (z <= section[j + 1].z || j + 1 == kShoulder) {
        const Vec3 a = section[j], b = section[j + 1];
        return a + (b - a) * std::min(1.0, (z - a.z) / (b.z - a.z));
      }
    return section[kShoulder];
  }

  // Points kSill to kBelt, lifted to an arch's edge.
  Section side_at(const Station& station) const {
    constexpr double kAboveArch_m = 0.03;
    Section section = sections.at(station.along_m);
    if (level == CarLevel::kOutline) section[kSill].z = station.low_m;
    if (station.arch == 0) return section;
    const double top = section[kShoulder].z, sill = section[kSill].z, low = std::min(station.low_m, top - kAboveArch_m);
    Section lifted = section;
    for (std::size_t j = kSill; j < kShoulder; ++j)
      lifted[j] = on_side(section, low + (section[j].z - sill) / (top - sill) * (top - low));
    return lifted;
  }

  double lamp_end_m() const { return 1.1 * shape.corner_m + 0.1; }
  double tail_lamp_m() const { return 0.7 * shape.corner_m + 0.06; }

  const Surface& side_surface(std::size_t row, double along_m) const {
    const bool is_front = along_m<lamp_end_m(), is_rear = along_m> end_m - tail_lamp_m() && !is_cab();
    if (level != CarLevel::kOutline && row == kShoulder && is_front) return surfaces.lamp;
    if (level != CarLevel::kOutline && row == kWidest && is_rear) return surfaces.tail_lamp;
    return row == kSill && shape.is_clad && is_full() ? surfaces.dark : surfaces.paint;
  }

  std::vector<std::size_t> side_rows() const {
    if (level == CarLevel::kOutline) return {kSill, kBelt};
    if (level == CarLevel::kPlain) return {kSill, kWidest, kShoulder, kBelt};
    return {kSill, kLower, kWidest, kShoulder, kBelt};
  }

  void add_sides() {
    const std::vector<Station> stations = side_stations();
    const std::vector<std::size_t> rows = side_rows();
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
      const Station &a = stations[i], &b = stations[i + 1];
      const Section from = side_at(a), to = side_at(b);
      if (a.arch != 0 || b.arch != 0) add_well(std::max(a.arch, b.arch), from[kSill], to[kSill]);
      if (a.arch != b.arch) continue;
      for (std::size_t r = 0; r + 1 < rows.size(); ++r)
        add_panel(from, to, rows[r], rows[r + 1], side_surface(rows[r], (a.along_m + b.along_m) / 2));
      add_floor(a, from[kSill], to[kSill]);
    }
  }

  void add_panel(const Section& from, const Section& to, std::size_t low, std::size_t high, const Surface& surface) {
    facets.add_twice(placed(from[low]), placed(to[low]), placed(to[high]), placed(from[high]), surface);
  }

  double well_x() const { return shape.width_m / 2 - kWellDepth_m; }

  void add_floor(const Station& a, Vec3 from, Vec3 to) {
    if (a.arch != 0) from.x = to.x = well_x(), from.z = to.z = shape.sill_m;
    facets.add(placed(from), placed({-from.x, from.y, from.z}), placed({-to.x, to.y, to.z}), placed(to), surfaces.dark);
  }

  // The part of a well behind a piece of the arch, or below its ends, and its wall.
  void add_well(int arch, Vec3 from, Vec3 to) {
    const double axle_m = arch == 1 ? shape.front_axle_m : shape.rear_axle_m, x = well_x();
    const Vec3 inner_from{x, from.y, from.z}, inner_to{x, to.y, to.z}, foot{x, axle_m, shape.sill_m};
    facets.add_twice(placed(from), placed(inner_from), placed(inner_to), placed(to), surfaces.dark);
    facets.add_twice(placed(foot), placed(inner_to), placed(inner_from), placed(foot), surfaces.dark);
  }

  // ---- windows and roof -----------------------------------------------------------------------------------------

  const Surface& pane_surface(double along_m) const {
    const std::span<const double> w = shape.windows;
    if (along_m < w.front() || along_m > w.back()) return surfaces.paint;
    if (!is_full()) return surfaces.glass;
    for (std::size_t i = 0; i < w.size(); i += 2)
      if (along_m > w[i] && along_m < w[i + 1]) return surfaces.glass;
    return surfaces.dark;
  }

  const Surface& upper_surface(std::size_t row, double along_m) const {
    if (row == kPaneFoot) return pane_surface(along_m);
    if (row < kRoofEdge) return surfaces.paint;
    if (along_m > shape.screen_from_m && along_m < shape.screen_to_m) return surfaces.glass;
    const double rear_to_m = level == CarLevel::kOutline ? end_m : shape.rear_to_m;
    if (along_m > shape.rear_from_m && along_m < rear_to_m && has_rear_window() && !is_bed(shape, along_m))
      return surfaces.glass;
    return is_bed(shape, along_m) ? surfaces.dark : surfaces.paint;
  }

  std::vector<std::size_t> upper_rows() const {
    if (level == CarLevel::kOutline) return {kBelt, kPaneHead, kMiddle};
    if (level == CarLevel::kPlain) return {kBelt, kPaneFoot, kPaneHead, kRoofEdge, kMiddle};
    return {kBelt, kPaneFoot, kPaneHead, kRoofEdge, kRoofHalf, kMiddle};
  }

  // The row by which a panel is named: at the outline, panes reach from the belt to the roof.
  std::size_t row_of_surface(std::size_t row) const {
    if (level != CarLevel::kOutline) return row;
    return row == kBelt ? kPaneFoot : kRoofEdge;
  }

  void add_upper() {
    const std::vector<double> places = upper_places();
    const std::vector<std::size_t> rows = upper_rows();
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Section from = sections.at(places[i]), to = sections.at(places[i + 1]);
      const double middle_m = (places[i] + places[i + 1]) / 2;
      for (std::size_t r = 0; r + 1 < rows.size(); ++r)
        add_panel(from, to, rows[r], rows[r + 1], upper_surface(row_of_surface(rows[r]), middle_m));
    }
  }

  // ---- ends -----------------------------------------------------------------------------------------------------

  // The place of a row of an end, at a share of its half width: ends are round in plan.
  Vec3 end_point(const Section& section, std::size_t row, double share, bool is_front) const {
    const double out = section[row].x / (shape.width_m / 2);
    const double bulge_m = 0.35 * shape.corner_m * out * out * (1 - share * share);
    return {section[row].x * share, section[row].y + (is_front ? -bulge_m : bulge_m), section[row].z};
  }

  const Surface& end_surface(std::size_t row, double share, bool is_front) const {
    if (level == CarLevel::kOutline) return surfaces.paint;
    const bool is_outer = share > 0.66;
    if (!is_front) {
      if (row == kSill && is_full()) return surfaces.dark;
      return row == kWidest && is_outer && !is_cab() ? surfaces.tail_lamp : surfaces.paint;
    }
    if (row == kShoulder) return is_outer ? surfaces.lamp : surfaces.dark;
    if (row == kSill || (row == kLower && !is_outer)) return is_full() ? surfaces.dark : surfaces.paint;
    return surfaces.paint;
  }

  void add_end(bool is_front) {
    Section section = sections.at(is_front ? 0 : end_m);
    if (level == CarLevel::kOutline) section[kSill].z = kOutlineFoot_m;
    std::vector<std::size_t> rows = side_rows();
    for (const std::size_t row : upper_rows())
      if (row > kBelt && row < kRoofHalf) rows.push_back(row);
    const std::vector<double> shares =
        is_full() ? std::vector<double>{0, 0.33, 0.66, 1} : std::vector<double>{0, 0.66, 1};
    for (std::size_t r = 0; r + 1 < rows.size(); ++r)
      for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        const Vec3 a = end_point(section, rows[r], shares[k], is_front),
                   b = end_point(section, rows[r], shares[k + 1], is_front),
                   c = end_point(section, rows[r + 1], shares[k + 1], is_front),
                   d = end_point(section, rows[r + 1], shares[k], is_front);
        const Surface& surface = end_surface(rows[r], (shares[k] + shares[k + 1]) / 2, is_front);
        if (is_front)
          facets.add_twice(placed(a), placed(b), placed(c), placed(d), surface);
        else
          facets.add_twice(placed(a), placed(d), placed(c), placed(b), surface);
      }
  }

  // ---- what is on the shell -------------------------------------------------------------------------------------

  void add_plate(bool is_front) {
    constexpr double kHalf_m = 0.26, kHigh_m = 0.11, kOff_m = 0.012;
    const Section section = sections.at(is_front ? 0 : end_m);
    const double z = is_front ? section[kWidest].z - 0.06 : section[kWidest].z + 0.04;
    double y = section[kLower].y;
    for (const std::size_t row : {kLower, kWidest, kShoulder}) {
      const double at = end_point(section, row, 0, is_front).y;
      y = is_front ? std::min(y, at) : std::max(y, at);
    }
    y += is_front ? -kOff_m : kOff_m;
    const double x = is_front ? kHalf_m : -kHalf_m;
    facets.add(placed({-x, y, z}), placed({x, y, z}), placed({x, y, z + kHigh_m}), placed({-x, y, z + kHigh_m}),
               surfaces.plate);
  }

  // The gap beside a door: a thin line before the paint.
  void add_seam(double along_m) {
    constexpr double kHalf_m = 0.005, kOff_m = 0.003;
    for (const double axle_m : {shape.front_axle_m, shape.rear_axle_m})
      if (std::abs(along_m - axle_m) < arch_m(shape)) return;
    const Section from = sections.at(along_m - kHalf_m), to = sections.at(along_m + kHalf_m);
    const auto before = [&](Vec3 p) { return placed({p.x + kOff_m, p.y, p.z}); };
    for (const std::size_t row : {kLower, kWidest, kShoulder})
      facets.add_twice(before(from[row]), before(to[row]), before(to[row + 1]), before(from[row + 1]), surfaces.dark);
  }

  void add_handle(double along_m) {
    constexpr double kLong_m = 0.17, kHigh_m = 0.028, kOff_m = 0.012;
    const Section section = sections.at(along_m);
    const double x = section[kShoulder].x + kOff_m, z = section[kShoulder].z - 0.02;
    facets.add_twice(placed({x, along_m, z}), placed({x, along_m + kLong_m, z}),
                     placed({x - 0.006, along_m + kLong_m, z + kHigh_m}), placed({x - 0.006, along_m, z + kHigh_m}),
                     surfaces.dark);
  }

  void add_doors() {
    const std::span<const double> w = shape.windows;
    add_seam(w[0] - 0.1);
    for (std::size_t i = 0; i < std::min<std::size_t>(w.size(), 4); i += 2) {
      add_seam(w[i + 1] + 0.035);
      add_handle(w[i + 1] - 0.24);
    }
  }

  void add_mirrors() {
    const double along_m = shape.windows[0] + 0.03;
    const Section section = sections.at(along_m);
    const double x = section[kPaneFoot].x, z = section[kPaneFoot].z + 0.02, size = shape.height_m > 2 ? 0.24 : 0.15;
    for (const double side : {1.0, -1.0}) {
      const double a = side * (x - 0.03), b = side * (x + 0.17);
      facets.add_box(placed({std::min(a, b), along_m, z}), placed({std::max(a, b), along_m + 0.09, z + size}),
                     surfaces.paint);
    }
  }

  // A lorry carries a box on a frame.
  void add_load() {
    const double floor_m = shape.wheel_m * 2 + 0.15, half_m = shape.width_m / 2, from_m = shape.rear_to_m + 0.12;
    facets.add_box(placed({-half_m, from_m, floor_m}), placed({half_m, shape.length_m, shape.height_m}), surfaces.load);
    const double foot_m = level == CarLevel::kOutline ? kOutlineFoot_m : floor_m - 0.35;
    facets.add_box(placed({-0.45, from_m - 0.3, foot_m}), placed({0.45, shape.length_m - 0.1, floor_m}), surfaces.dark);
  }

  void add_all() {
    add_sides();
    add_upper();
    for (const bool is_front : {true, false}) add_end(is_front);
    if (is_cab()) add_load();
    if (!is_full()) return;
    add_plate(true);
    if (!is_cab()) add_plate(false);
    if (shape.body != "bus") add_doors();
    add_mirrors();
  }
};

// ---- wheels -----------------------------------------------------------------------------------------------------

// A band of a wheel between two circles: outwards from its middle, and radius.
struct WheelMaker {
  Facets& facets;
  Vec3 middle;
  double side = 1;  // 1 or -1
  int parts = 18;

  Vec3 point(int i, Vec2 circle) const {
    const Vec2 turn = direction_of(static_cast<double>(i) / parts);
    return middle + Vec3{side * circle.x, circle.y * turn.x, circle.y * turn.y};
  }

  template <typename SurfaceAt>
  void add_band(Vec2 from, Vec2 to, SurfaceAt surface_at) {
    for (int i = 0; i < parts; ++i) {
      const Vec3 a = point(i, from), b = point(i + 1, from), c = point(i + 1, to), d = point(i, to);
      if (side > 0)
        facets.add(a, b, c, d, surface_at(i));
      else
        facets.add(a, d, c, b, surface_at(i));
    }
  }
};

void add_wheel(Vec3 middle, double side, double radius_m, CarLevel level, const CarSurfaces& surfaces, Facets& facets) {
  constexpr double kHalf_m = 0.1;
  const double r = radius_m;
  WheelMaker maker{facets, middle, side, level == CarLevel::kFull ? 15 : 8};
  const auto tyre = [&](int) -> const Surface& { return surfaces.dark; };
  const auto rim = [&](int) -> const Surface& { return surfaces.rim; };
  if (level != CarLevel::kFull) {
    maker.add_band({-kHalf_m, r}, {kHalf_m, r}, tyre);
    maker.add_band({kHalf_m, r}, {kHalf_m, 0.66 * r}, tyre);
    return maker.add_band({kHalf_m, 0.66 * r}, {kHalf_m, 0}, rim);
  }
  const auto spoke = [&](int i) -> const Surface& { return i % 3 == 0 ? surfaces.dark : surfaces.rim; };
  maker.add_band({-kHalf_m, 0.97 * r}, {0.8 * kHalf_m, r}, tyre);
  maker.add_band({0.8 * kHalf_m, r}, {kHalf_m, 0.9 * r}, tyre);
  maker.add_band({kHalf_m, 0.9 * r}, {0.95 * kHalf_m, 0.68 * r}, tyre);
  maker.add_band({0.95 * kHalf_m, 0.68 * r}, {0.65 * kHalf_m, 0.62 * r}, rim);
  maker.add_band({0.65 * kHalf_m, 0.62 * r}, {0.8 * kHalf_m, 0.2 * r}, spoke);
  maker.add_band({0.8 * kHalf_m, 0.2 * r}, {0.85 * kHalf_m, 0}, rim);
}

materials::Tint tint_of_srgb(std::uint32_t rgb) {
  const auto channel = [&](int shift) {
    // a tint multiplies the reflectance of the material, 0.9
    const double share = materials::linear_of_srgb(static_cast<std::uint8_t>(rgb >> shift & 255)) / 0.9;
    return static_cast<std::uint8_t>(std::min(255.0, share * 255 + 0.5));
  };
  return {channel(16), channel(8), channel(0), 255};
}

}  // namespace

CarSurfaces car_surfaces(materials::Tint paint) {
  using enum materials::Material;
  return {.paint = {kCarPaint, paint, true},
          .glass = {kGlass, materials::kNoTint, false},
          .dark = {kPaint, tint_of_srgb(0x232426), false},
          .lamp = {kCarPaint, tint_of_srgb(0xc9ced2), false},
          .tail_lamp = {kCarPaint, tint_of_srgb(0x8e1519), false},
          .plate = {kCarPaint, tint_of_srgb(0xe4e4de), false},
          .rim = {kCarPaint, tint_of_srgb(0x9a9da0), false},
          .load = {kCarPaint, tint_of_srgb(0xd9dad6), false}};
}

void add_body(const CarShape& shape, CarLevel level, const CarSurfaces& surfaces, Facets& facets) {
  BodyMaker{shape, level, surfaces, facets}.add_all();
}

void add_wheels(const CarShape& shape, CarLevel level, const CarSurfaces& surfaces, Facets& facets) {
  if (level == CarLevel::kOutline) return;
  for (const double along_m : {shape.front_axle_m, shape.rear_axle_m})
    for (const double side : {1.0, -1.0})
      add_wheel({side * (shape.width_m / 2 - 0.13), along_m - shape.length_m / 2, shape.wheel_m}, side, shape.wheel_m,
                level, surfaces, facets);
}

}  // namespace citykiln::cars
