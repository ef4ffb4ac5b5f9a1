#include "compiler/buildings/facade_rows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "compiler/geometry/polygon.h"

namespace citykiln::buildings {
namespace {

using impostor::Picture;
using impostor::SharedPicture;
using impostor::Texel;

// A face with its frame, for the search.
struct FlatWall {
  grammars::FaceFrame frame;
  Polygon outline;
  Box2 box;
};

FlatWall flat_wall(const grammars::Face& face) {
  const std::array<Vec3, 3> axis = grammars::axes_of(face);
  FlatWall wall{{face.outer.front(), axis[0], axis[1], axis[2]}, {}, {}};
  wall.outline = grammars::flat(face, wall.frame);
  for (const Vec2 p : wall.outline.outer) wall.box.grow(p);
  return wall;
}

Box2 box_on(const FlatWall& wall, const grammars::Face& rectangle) {
  Box2 box;
  for (const Vec3 p : rectangle.outer) box.grow(wall.frame.to_plane(p));
  return box;
}

// True if a box, but for rounding errors, lies in the wall. Rings that enter it between its corners are not seen.
bool has_room(const FlatWall& wall, const Box2& box) {
  constexpr double kSlack_m = 0.01;
  const Vec2 low = box.min + Vec2{kSlack_m, kSlack_m}, high = box.max - Vec2{kSlack_m, kSlack_m};
  if (!wall.box.contains(low) || !wall.box.contains(high)) return false;
  for (const Vec2 p : {low, Vec2{high.x, low.y}, high, Vec2{low.x, high.y}, (low + high) * 0.5})
    if (!contains(wall.outline, p)) return false;
  return true;
}

bool is_parallel(const FlatWall& wall, Vec3 normal) {
  constexpr double kLeastCosine = 0.999;
  return dot(wall.frame.z, normal) > kLeastCosine;
}

// Elements of one size in rows and columns at equal distances, the lowest row first, each from left to right.
struct GridOfElements {
  const WallWithElements* wall;
  std::vector<const ElementOnWall*> elements;
  std::size_t columns;
  Vec2 step_m;  // from one to the next; 0 if there is no next

  std::size_t rows() const { return elements.size() / columns; }
  const Box2& first() const { return elements.front()->box; }
};

// All that the picture of a grid depends on, but for what its elements look like. Lengths are in texels.
struct GridKey {
  std::int32_t wide, high;
  std::int32_t step_x, step_y;  // 0 if there is one column, or one row
  Texel wall;
  const impostor::PackedPicture* alone;  // null if there are several elements
  auto operator<=>(const GridKey&) const = default;
};

bool are_near(double a, double b, const RowSizes& sizes) { return std::abs(a - b) <= sizes.same_m; }

bool have_one_size(const Box2& a, const Box2& b, const RowSizes& sizes) {
  return are_near(a.width(), b.width(), sizes) && are_near(a.height(), b.height(), sizes);
}

// True if an element as long as `long_m` and the next one, at a distance, may be on one picture.
bool may_be_joined(double step_m, double long_m, const RowSizes& sizes) {
  constexpr double kWidestGap_m = 4;
  return step_m > long_m - sizes.same_m && step_m - long_m <= kWidestGap_m;
}

std::vector<const ElementOnWall*> row_by_row(const WallWithElements& wall, const RowSizes& sizes) {
  const auto steps = [&](double v) { return std::floor(v / sizes.same_m + 0.5); };
  const auto key = [&](const ElementOnWall* e) {
    return std::tuple(steps(e->box.min.y), steps(e->box.height()), steps(e->box.width()), e->box.min.x);
  };
  std::vector<const ElementOnWall*> order;
  for (const ElementOnWall& element : wall.elements) order.push_back(&element);
  std::ranges::stable_sort(order, [&](const auto* a, const auto* b) { return key(a) < key(b); });
  return order;
}

// True if no element reaches into a part of the wall that a picture would show as bare.
bool is_bare(const WallWithElements& wall, const Box2& part) {
  return std::ranges::none_of(wall.elements, [&](const ElementOnWall& e) {
    return e.box.min.x < part.max.x && part.min.x < e.box.max.x && e.box.min.y < part.max.y && part.min.y < e.box.max.y;
  });
}

// The wall between two boxes, a little narrower: the second is to the right of the first, or above it.
Box2 wall_beside(const Box2& a, const Box2& b, double slack_m) {
  return {{a.max.x + slack_m, std::min(a.min.y, b.min.y)}, {b.min.x - slack_m, std::max(a.max.y, b.max.y)}};
}
Box2 wall_above(const Box2& a, const Box2& b, double slack_m) {
  return {{std::min(a.min.x, b.min.x), a.max.y + slack_m}, {std::max(a.max.x, b.max.x), b.min.y - slack_m}};
}

// The first elements that are a row. A long row is cut where its picture ends.
std::size_t length_of_row(const WallWithElements& wall, std::span<const ElementOnWall* const> elements,
                          const RowSizes& sizes) {
  const Box2& first = elements.front()->box;
  const auto step_to = [&](std::size_t i) { return elements[i]->box.min.x - elements[i - 1]->box.min.x; };
  std::size_t count = 1;
  for (; count < std::min<std::size_t>(elements.size(), kWindowsOfPicture); ++count) {
    const Box2& next = elements[count]->box;
    if (!are_near(next.min.y, first.min.y, sizes) || !have_one_size(next, first, sizes)) break;
    if (!may_be_joined(step_to(count), first.width(), sizes) || !are_near(step_to(count), step_to(1), sizes)) break;
    if (!is_bare(wall, wall_beside(elements[count - 1]->box, next, sizes.same_m))) break;
  }
  return count;
}

std::vector<GridOfElements> rows_on(const WallWithElements& wall, const RowSizes& sizes) {
  std::vector<GridOfElements> rows;
  const std::vector<const ElementOnWall*> order = row_by_row(wall, sizes);
  for (std::span<const ElementOnWall* const> rest = order; !rest.empty(); rest = rest.subspan(rows.back().columns)) {
    const std::size_t count = length_of_row(wall, rest, sizes);
    const double step_m = count > 1 ? rest[1]->box.min.x - rest[0]->box.min.x : 0;
    rows.push_back({&wall, {rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(count)}, count, {step_m, 0}});
  }
  return rows;
}

Box2 box_of_row(const GridOfElements& grid, std::size_t row) {
  const std::size_t first = row * grid.columns;
  return {grid.elements[first]->box.min, grid.elements[first + grid.columns - 1]->box.max};
}

// True if a row may be the next one above a grid.
bool continues(const GridOfElements& grid, const GridOfElements& row, const RowSizes& sizes) {
  const Box2 &first = grid.first(), &next = row.first();
  const double step_m = next.min.y - grid.elements.back()->box.min.y;
  return grid.columns == row.columns && grid.rows() < kWindowsOfPicture &&
         are_near(grid.step_m.x, row.step_m.x, sizes) && are_near(first.min.x, next.min.x, sizes) &&
         have_one_size(first, next, sizes) && may_be_joined(step_m, first.height(), sizes) &&
         (grid.rows() == 1 || are_near(step_m, grid.step_m.y, sizes)) &&
         is_bare(*grid.wall, wall_above(box_of_row(grid, grid.rows() - 1), box_of_row(row, 0), sizes.same_m));
}

std::vector<GridOfElements> grids_on(const WallWithElements& wall, const RowSizes& sizes) {
  std::vector<GridOfElements> grids;
  for (GridOfElements& row : rows_on(wall, sizes)) {
    const auto below = std::ranges::find_if(grids, [&](const auto& grid) { return continues(grid, row, sizes); });
    if (below == grids.end()) {
      grids.push_back(std::move(row));
      continue;
    }
    if (below->rows() == 1) below->step_m.y = row.first().min.y - below->first().min.y;
    below->elements.insert(below->elements.end(), row.elements.begin(), row.elements.end());
  }
  return grids;
}

std::int32_t texels(double length_m, double texel_m) {
  return std::max(1, static_cast<std::int32_t>(std::floor(length_m / texel_m + 0.5)));
}

GridKey key_of_grid(const GridOfElements& grid, double texel_m) {
  const std::int32_t wide = texels(grid.first().width(), texel_m), high = texels(grid.first().height(), texel_m);
  if (grid.elements.size() == 1) return {wide, high, 0, 0, {}, grid.elements.front()->seen.get()};
  const auto step = [&](double step_m, std::int32_t side) {
    return step_m == 0 ? 0 : std::max(side, texels(step_m, texel_m));
  };
  return {wide, high, step(grid.step_m.x, wide), step(grid.step_m.y, high), grid.wall->colour, nullptr};
}

// The grids of one key: how often each picture is seen in them, in the order in which they are met, and the most
// columns and rows that any has.
struct SeenPictures {
  std::vector<std::pair<SharedPicture, std::uint32_t>> counts;
  std::size_t columns = 1, rows = 1, grids = 0, elements = 0;

  void add(const GridOfElements& grid) {
    ++grids, elements += grid.elements.size();
    columns = std::max(columns, grid.columns), rows = std::max(rows, grid.rows());
    for (const ElementOnWall* element : grid.elements) add(element->seen);
  }

  void add(const SharedPicture& picture) {
    const auto at = std::ranges::find(counts, picture, [](const auto& each) { return each.first; });
    if (at != counts.end())
      ++at->second;
    else
      counts.emplace_back(picture, 1);
  }

  // By the method of D'Hondt: each picture has its share of the places.
  std::vector<SharedPicture> chosen() const {
    std::vector<SharedPicture> places;
    std::vector<std::uint32_t> given(counts.size());
    while (places.size() < columns * rows) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < counts.size(); ++i)
        if (counts[i].second * (given[best] + 1) > counts[best].second * (given[i] + 1)) best = i;
      places.push_back(counts[best].first), ++given[best];
    }
    return places;
  }
};

// The element at a lower resolution: at least the texels that its place has.
Picture shrunk(const impostor::PackedPicture& picture, const GridKey& key) {
  Picture small = impostor::unpacked(picture);
  while (small.columns >= 2 * static_cast<std::uint32_t>(key.wide) &&
         small.rows >= 2 * static_cast<std::uint32_t>(key.high))
    small = halved(small);
  return small;
}

// The texels that a number of columns and rows take.
struct GridSpan {
  std::uint32_t columns, rows;
};
GridSpan span_of(const GridKey& key, std::size_t columns, std::size_t rows) {
  const auto texels = [](std::int32_t side, std::int32_t step, std::size_t count) {
    return static_cast<std::uint32_t>(side + static_cast<std::int32_t>(count - 1) * step);
  };
  return {texels(key.wide, key.step_x, columns), texels(key.high, key.step_y, rows)};
}

// Draws an element with its upper left corner at a texel.
void draw_element(const Picture& element, const GridKey& key, std::size_t column, std::size_t row, Picture& picture) {
  const auto wide = static_cast<std::size_t>(key.wide), high = static_cast<std::size_t>(key.high);
  for (std::size_t y = 0; y < high; ++y)
    for (std::size_t x = 0; x < wide; ++x) {
      const std::size_t from_y = (2 * y + 1) * element.rows / (2 * high);
      const std::size_t from_x = (2 * x + 1) * element.columns / (2 * wide);
      Texel& texel = picture.texels[(row + y) * picture.columns + column + x];
      texel = element.texels[from_y * element.columns + from_x];
      texel.slope = {};  // steps of frames are narrower than a texel
    }
}

SharedPicture picture_of_grid(const GridKey& key, const SeenPictures& seen) {
  const GridSpan all = span_of(key, seen.columns, seen.rows);
  Picture picture{all.columns, all.rows, {}};
  picture.texels.assign(std::size_t{picture.columns} * picture.rows, key.wall);
  std::map<const impostor::PackedPicture*, Picture> small;
  const std::vector<SharedPicture> places = seen.chosen();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto [at, is_new] = small.try_emplace(places[i].get());
    if (is_new) at->second = shrunk(*places[i], key);
    const std::size_t x = i % seen.columns, y = i / seen.columns;
    draw_element(at->second, key, x * static_cast<std::size_t>(key.step_x), y * static_cast<std::size_t>(key.step_y),
                 picture);
  }
  fill_gaps(picture);
  return impostor::shared(picture);
}

// Adds the rectangle of a grid, which shows a part of the picture: as many windows as it has, after `skipped` columns.
void add_grid(const GridOfElements& grid, const GridKey& key, const RowSizes& sizes, std::size_t skipped,
              TexturedFace& textured) {
  const grammars::FaceFrame& frame = grid.wall->frame;
  const Box2 box{grid.first().min, grid.elements.back()->box.max};
  const GridSpan shown = span_of(key, grid.columns, grid.rows());
  const double unit_m = sizes.texel_on_atlas_m, left = static_cast<double>(skipped) * key.step_x * unit_m;
  const double right = left + shown.columns * unit_m, high = shown.rows * unit_m;
  Mesh& mesh = textured.mesh.mesh;
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vec2 p : {box.min, Vec2{box.max.x, box.min.y}, box.max, Vec2{box.min.x, box.max.y}})
    mesh.positions.push_back(frame.to_space(p) + frame.z * sizes.before_m);
  for (const Vec2 uv : {Vec2{left, high}, Vec2{right, high}, Vec2{right, 0}, Vec2{left, 0}})
    textured.mesh.uvs.push_back(uv);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

struct GridWithKey {
  GridOfElements grid;
  GridKey key;
};

std::map<GridKey, SeenPictures> seen_in(std::span<const GridWithKey> grids) {
  std::map<GridKey, SeenPictures> seen;
  for (const auto& [grid, key] : grids) seen[key].add(grid);
  return seen;
}

// True if a picture takes more bytes than the corners that it saves. A rectangle takes as many as 260 texels, as
// measured: 78 bytes.
bool is_dear(const GridKey& key, const SeenPictures& seen) {
  constexpr std::size_t kTexelsOfRectangle = 260;
  const GridSpan all = span_of(key, seen.columns, seen.rows);
  return std::size_t{all.columns} * all.rows > kTexelsOfRectangle * (seen.elements - seen.grids);
}

// Takes grids apart whose picture is dear.
std::vector<GridWithKey> without_dear_pictures(std::vector<GridWithKey>&& grids, const RowSizes& sizes) {
  const std::map<GridKey, SeenPictures> seen = seen_in(grids);
  std::vector<GridWithKey> kept;
  for (GridWithKey& each : grids) {
    if (each.key.alone || !is_dear(each.key, seen.at(each.key))) {
      kept.push_back(std::move(each));
      continue;
    }
    for (const ElementOnWall* element : each.grid.elements) {
      GridOfElements single{each.grid.wall, {element}, 1, {}};
      const GridKey key = key_of_grid(single, sizes.texel_m);
      kept.push_back({std::move(single), key});
    }
  }
  return kept;
}

}  // namespace

std::vector<std::vector<ElementOnWall>> elements_on(std::span<const grammars::Face> faces,
                                                    std::span<const PlacedElement> elements, double reach_m) {
  std::vector<FlatWall> walls;
  for (const grammars::Face& face : faces) walls.push_back(flat_wall(face));
  std::vector<std::vector<ElementOnWall>> on_faces(faces.size());
  for (const PlacedElement& element : elements) {
    const Vec3 corner = element.rectangle.outer.front(), normal = grammars::axes_of(element.rectangle)[2];
    double nearest_m = reach_m;
    std::size_t best = walls.size();
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const double away_m = std::abs(dot(corner - walls[i].frame.origin, walls[i].frame.z));
      if (away_m >= nearest_m || !is_parallel(walls[i], normal)) continue;
      if (has_room(walls[i], box_on(walls[i], element.rectangle))) nearest_m = away_m, best = i;
    }
    if (best < walls.size())
      on_faces[best].push_back({box_on(walls[best], element.rectangle), element.picture, nearest_m});
  }
  return on_faces;
}

RowSizes row_sizes(double tolerance_m) {
  return {.texel_m = std::max(kCoarseElementTexel_m, tolerance_m / 4),
          .before_m = tolerance_m / 16,
          .same_m = std::max(0.03, tolerance_m / 10),
          .texel_on_atlas_m = tolerance_m};
}

std::vector<TexturedFace> rows_of(std::span<const WallWithElements> walls, const RowSizes& sizes, OsmId feature) {
  std::vector<GridWithKey> grids;
  for (const WallWithElements& wall : walls)
    for (GridOfElements& grid : grids_on(wall, sizes)) {
      const GridKey key = key_of_grid(grid, sizes.texel_m);
      grids.push_back({std::move(grid), key});
    }
  grids = without_dear_pictures(std::move(grids), sizes);
  const std::map<GridKey, SeenPictures> seen = seen_in(grids);
  std::vector<TexturedFace> faces;
  std::map<GridKey, std::pair<std::size_t, std::size_t>> place_of;  // among faces, and the number of grids up to now
  for (const auto& [grid, key] : grids) {
    const SeenPictures& pictures = seen.at(key);
    const auto [at, is_new] = place_of.try_emplace(key, faces.size(), 0);
    if (is_new) faces.push_back(textured_by(picture_of_grid(key, pictures), feature));
    const std::size_t places = pictures.columns - grid.columns + 1;
    add_grid(grid, key, sizes, at->second.second++ % places, faces[at->second.first]);
  }
  return faces;
}

}  // namespace citykiln::buildings
