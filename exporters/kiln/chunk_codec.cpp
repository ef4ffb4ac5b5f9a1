#include "exporters/kiln/chunk_codec.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include "compiler/map/element_text.h"
#include "compiler/map/plane/smooth_land.h"
#include "compiler/scene/yard_recipes.h"
#include "exporters/kiln/building_codec.h"
#include "exporters/kiln/line_codec.h"
#include "exporters/kiln/member_codecs.h"
#include "exporters/kiln/road_codec.h"
#include "exporters/kiln/thing_codec.h"
#include "exporters/kiln/yard_codec.h"

// Writing and reading share their code: serialise() visits all fields of a chunk in order, and passes them to a Writer
// or a Reader.
namespace citykiln::exporters {
namespace {

using scene::Chunk;

// Reads and writes the texts of OSM elements in a chunk (the recipes of one tile): names, each once per chunk, and
// tags. `io` is a Writer or a Reader (chunk_io.h).

// The names of a chunk in the order in which they appear; the first one is empty.
struct NameList {
  std::vector<std::string> names = {""};
  std::map<std::string, std::size_t> numbers = {{"", 0}};

  std::size_t number_of(const std::string& name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? names.size() : found->second;
  }
  void add(const std::string& name) { numbers.emplace(name, names.size()), names.push_back(name); }
};

// A name: its number in the list. The number after the last one means a new name, which follows.
void name(auto& io, NameList& list, std::string& value) {
  std::size_t number = list.number_of(value);
  io.number("name number", number);
  const bool is_new = number == list.names.size();
  if (is_new) io.text("name size", "name bytes", value);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number > list.names.size() || value.size() > map::kMostNameBytes) return io.fail("name number");
  if (is_new) list.add(value);
  value = list.names[number];
}

// The texts of all elements of a chunk, sorted by id.
void texts(auto& io, std::vector<map::ElementText>& all) {
  NameList names;
  std::optional<OsmId> before;
  list(io, "texts", all, 0, [&](map::ElementText& text) {
    enumerator(io, "id type", text.id.type, static_cast<OsmType>(kOsmTypeCount));
    io.delta("id", text.id.id);
    name(io, names, text.name);
    io.tags("tags size", "tags bytes", text.tags);
    if constexpr (std::remove_reference_t<decltype(io)>::kReads)
      if (before && !(*before < text.id)) io.fail("id");
    before = text.id;
  });
}

constexpr std::size_t kMostPerFile = 1u << 28;

// The level of standing water; other surfaces have none.
void level(auto& io, ground::LandCoverPolygon& s) {
  bool is_levelled = s.level_m.has_value();
  flag(io, "levelled", is_levelled);
  if (!is_levelled) return;
  if (!s.level_m) s.level_m.emplace();
  quanta(io, "water level", *s.level_m, kProfileQuantum_m);
}

// One number: whether the surface belongs to a graded road, and twice the priority of the areas it lies in.
void standing(auto& io, ground::LandCoverPolygon& s) {
  auto number = static_cast<std::uint16_t>(s.raised_priority << 1 | s.is_graded);
  io.number("graded", number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (number >> 1 > 0xff) io.fail("graded"), number = 0;
  s.is_graded = (number & 1) != 0, s.raised_priority = static_cast<std::uint8_t>(number >> 1);
}

void serialise(auto& io, ground::LandCoverPolygon& s) {
  id(io, s.id);
  enumerator(io, "surface class", s.surface, map::LandCoverClass::kCount);
  io.number("surface area", s.area_m2);
  list(io, "surface rings", s.rings, 1, [&](Ring& ring) { points(io, "ring points", ring, 3); });
  level(io, s);
  standing(io, s);
  if (map::is_field(s.surface)) io.number("field rows", s.row_heading);
}

void species_mix(auto& io, Stream name, plants::SpeciesMix& species_mix) {
  auto number = static_cast<std::uint8_t>(species_mix);
  io.number(name, number);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (!plants::is_species_mix(number)) io.fail(name), number = 0;
  species_mix = plants::SpeciesMix{number};
}

// A whole number of eighths of a metre, less than 256 m.
void eighths(auto& io, Stream name, double& value, double least_m) {
  auto count = static_cast<std::uint16_t>(value * 8);
  io.number(name, count);
  value = count / 8.0;
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (!(value >= least_m && value < 256)) io.fail(name), value = 1;
}

void serialise(auto& io, plants::Tree& t) {
  id(io, t.id);
  io.point(t.at), io.metres("tree height", t.height_m);
  species_mix(io, "tree species mix", t.species_mix);
}

void serialise(auto& io, plants::Wood& w) {
  id(io, w.surface);
  species_mix(io, "wood", w.species_mix), io.number("wood", w.trees_per_ha), eighths(io, "wood", w.height_m, 0.125);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    // a wood has some trees per hectare, but no million of them
    if (w.trees_per_ha < plants::kLeastTreesPerHa || w.trees_per_ha > plants::kMostTreesPerHa) io.fail("wood");
}

void serialise(auto& io, plants::Planting& p) {
  id(io, p.surface);
  species_mix(io, "planting", p.species_mix), io.number("planting", p.heading);
  eighths(io, "planting", p.row_spacing_m, plants::kLeastPlantSpacing_m),
      eighths(io, "planting", p.plant_spacing_m, plants::kLeastPlantSpacing_m);
  eighths(io, "planting", p.height_m, 0.125);
}

void serialise(auto& io, plants::TreeRow& r) {
  id(io, r.id);
  points(io, "tree row points", r.axis, 2);
  species_mix(io, "tree row", r.species_mix);
  eighths(io, "tree row", r.height_m, 0), eighths(io, "tree row", r.spacing_m, 0);
}

void serialise(auto& io, plants::PowerLineCorridor& l) {
  id(io, l.id);
  points(io, "power corridor points", l.axis, 2);
  eighths(io, "power corridor", l.width_m, 0);
}

// A barrier's kind; fences of a known build follow the kinds.
enum class BuiltBarrier : std::uint8_t {};
constexpr auto kBuiltBarriers = static_cast<BuiltBarrier>(map::kBarrierKinds + static_cast<int>(map::FenceKind::kMesh));

BuiltBarrier built_of(const props::Barrier& b) {
  if (b.kind != map::BarrierKind::kFence || b.fence == map::FenceKind::kAny) return static_cast<BuiltBarrier>(b.kind);
  return static_cast<BuiltBarrier>(map::kBarrierKinds + static_cast<int>(b.fence) - 1);
}

void set_built(BuiltBarrier built, props::Barrier& b) {
  const int build = static_cast<int>(built) - static_cast<int>(map::kBarrierKinds) + 1;
  b.kind = build > 0 ? map::BarrierKind::kFence : static_cast<map::BarrierKind>(built);
  b.fence = build > 0 ? static_cast<map::FenceKind>(build) : map::FenceKind::kAny;
}

void serialise(auto& io, props::Barrier& b) {
  id(io, b.id);
  curved_points(io, "barrier points", b.axis, 2);
  BuiltBarrier built = built_of(b);
  enumerator(io, "barrier kind", built, kBuiltBarriers);
  set_built(built, b);
  io.metres("barrier height", b.height_m), io.metres("barrier width", b.width_m);
}

void serialise(auto& io, ground::Landform& f) {
  serialise(io, static_cast<roads::Strip&>(f));
  enumerator(io, "landform kind", f.kind, ground::LandformKind::kCount);
}

template <typename Io>
void serialise(Io& io, pitches::Pitch& pitch) {
  id(io, pitch.id);
  enumerator(io, "sports field kind", pitch.kind, pitches::PitchKind::kCount);
  io.point(pitch.from), io.point(pitch.to);
  io.metres("sports field width", pitch.width_m);
  if constexpr (Io::kReads)
    if (pitch.from == pitch.to || !(pitch.width_m > 0)) io.fail("sports field width");
}

// The tags about a lamp's light; most lamps have none.
void light(auto& io, map::LampTags& tags) {
  bool is_tagged = tags != map::LampTags{};
  flag(io, "lamp light", is_tagged);
  if (!is_tagged) return;
  enumerator(io, "lamp light", tags.type, map::LampType::kCount);
  enumerator(io, "lamp light", tags.mount, map::LampMount::kCount);
  io.number("lamp light", tags.count), io.number("lamp light", tags.temperature_k);
  io.number("lamp light", tags.lumen);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (tags.count < 1 || tags.count > map::kMostLuminaires) io.fail("lamp light"), tags.count = 1;
}

void serialise(auto& io, props::Lamp& l) {
  id(io, l.id);
  io.point(l.at), io.metres("lamp height", l.height_m);
  light(io, l.light);
}

void wire_end(auto& io, Vec3& end) {
  quanta(io, "wire x", end.x, wires::kWireQuantum_m), quanta(io, "wire y", end.y, wires::kWireQuantum_m);
  quanta(io, "wire z", end.z, wires::kWireQuantum_m);
}

void serialise(auto& io, wires::Wire& w) {
  quanta(io, "wire sag", w.sag_m, wires::kWireQuantum_m);
  io.number("wire radius", w.radius_mm);
  enumerator(io, "wire kind", w.kind, wires::WireKind::kCount);
  if constexpr (std::remove_reference_t<decltype(io)>::kReads)
    if (w.sag_m < 0 || w.radius_mm == 0) io.fail("wire sag"), w.sag_m = 0, w.radius_mm = 1;
}

void serialise(auto& io, wires::WireSpan& s) {
  id(io, s.id);
  quanta(io, "wire height", s.above_m, 1);
  list(io, "wires", s.wires, 1, [&](wires::Wire& wire) { serialise(io, wire); });
  // ends beside each other are near
  for (wires::Wire& wire : s.wires) wire_end(io, wire.from);
  for (wires::Wire& wire : s.wires) wire_end(io, wire.to);
}

// The prediction of a height from its western, southern and south-western neighbours; the difference is written.
std::int64_t predicted_field_height(const map::Heightfield& h, std::size_t i) {
  const auto across = static_cast<std::size_t>(h.columns);
  const std::int64_t west = i % across > 0 ? h.heights[i - 1] : 0, south = i >= across ? h.heights[i - across] : 0;
  if (i % across == 0) return south;
  return i < across ? west : west + south - h.heights[i - across - 1];
}

// Whether corner and steps are whole eighths of a metre.
bool is_on_grid(const map::Heightfield& h) {
  const auto is_whole = [](double v, double step) { return std::floor(v / step) * step == v; };
  const auto fits = [&](double start, double step) {
    return step >= 1 && is_whole(step, map::kStepUnit_m) && is_whole(start, map::kStepUnit_m);
  };
  return fits(h.min.x, h.step_m.x) && fits(h.min.y, h.step_m.y);
}

// The largest height that is divided, in units of map::kHeightQuantum_m: 2¹⁰ km.
constexpr std::int64_t kMostSmoothed = std::int64_t{1} << 26;

int common_zeros(const map::Heightfield& h) {
  std::uint32_t all = 1u << 20;
  for (const std::int32_t height : h.heights) all |= static_cast<std::uint32_t>(height);
  return std::countr_zero(all);
}

template <typename Io>
void sampled_heights(Io& io, map::Heightfield& h) {
  io.metres("field", h.min.x), io.metres("field", h.min.y);
  io.metres("field", h.step_m.x), io.metres("field", h.step_m.y);
  io.number("field", h.columns), io.number("field", h.rows);
  io.metres("field", h.resampling_error_m);
  const std::size_t size = io.count("field", h.heights.size());
  if constexpr (Io::kReads) {
    const bool fits = h.columns >= 2 && h.rows >= 2 && is_on_grid(h) && h.resampling_error_m >= 0 &&
                      static_cast<std::uint64_t>(h.columns) * static_cast<std::uint64_t>(h.rows) == size &&
                      size < kMostPerFile;
    if (!fits) return io.fail("field");
    h.heights.resize(size);
  }
  // the low bits that are zero in all heights are not written
  int shift = common_zeros(h);
  io.number("field", shift);
  if constexpr (Io::kReads)
    if (shift < 0 || shift > 30) return io.fail("field");
  for (std::size_t i = 0; i < size; ++i) {
    std::int64_t off = (h.heights[i] - predicted_field_height(h, i)) >> shift;
    std::uint64_t zigzag = static_cast<std::uint64_t>(off) << 1 ^ static_cast<std::uint64_t>(off >> 63);
    io.number("heights", zigzag);
    if constexpr (Io::kReads) {
      const std::uint64_t undone = (zigzag >> 1 ^ (~(zigzag & 1) + 1)) << shift;
      const auto height = static_cast<std::int64_t>(static_cast<std::uint64_t>(predicted_field_height(h, i)) + undone);
      h.heights[i] = static_cast<std::int32_t>(height);
      if (h.heights[i] != height) return io.fail("heights");
    }
  }
}

// The samples of a heightfield, and the number of parts of a step between them: 1, 2 or 4.
template <typename Io>
void heights(Io& io, map::Heightfield& h) {
  int parts = h.parts;
  io.number("field", parts);
  map::Heightfield samples = map::samples_of(h);
  sampled_heights(io, samples);
  if constexpr (Io::kReads) {
    const bool is_divided = (parts == 2 || parts == 4) && samples.columns >= 4 && samples.rows >= 4;
    // the smooth surface may leave the range of its samples
    const bool fits = is_divided && std::ranges::all_of(samples.heights, [](std::int32_t height) {
                        return std::abs(std::int64_t{height}) <= kMostSmoothed;
                      });
    if ((parts != 1 && !fits) || !io.wrong.empty()) return io.fail("field");
    h = map::smooth_land(std::move(samples), parts);
  }
}

// The yards, and for each the gaps: what it generates but the chunk does not have.
void yards(auto& io, scene::StrippedChunk& stripped) {
  YardContext context{stripped.chunk.buildings};
  list(io, "yards", stripped.chunk.yards, 0, [&](lots::Yard& yard) { serialise(io, yard, context); });
  stripped.suppressed.resize(stripped.chunk.yards.size());
  for (std::vector<bool>& suppressed : stripped.suppressed) bits(io, "yard gaps", "yard gap bits", suppressed);
}

template <typename Io>
void serialise(Io& io, scene::StrippedChunk& stripped) {
  Chunk& c = stripped.chunk;
  std::uint64_t is_coarse = io.point_step_m == kMapStep_m ? 1 : 0;
  io.number("point step", is_coarse);
  if constexpr (Io::kReads)
    if (is_coarse > 1) io.fail("point step");
  io.point_step_m = is_coarse != 0 ? kMapStep_m : kQuantum_m;
  heights(io, c.heights);
  list(io, "surfaces", c.surfaces, 0, [&](auto& o) { serialise(io, o); });
  KindsOfChunk kinds = kinds_of_chunk(io, c);
  roads_of(io, c.roads, kinds);
  list(io, "junctions", c.junctions, 0, [&](auto& o) { serialise(io, o); });
  list(io, "watercourses", c.watercourses, 0, [&](auto& o) { serialise(io, o); });
  list(io, "bridges", c.bridges, 0, [&](auto& o) { serialise(io, o, kinds); });
  list(io, "tunnels", c.tunnels, 0, [&](auto& o) { serialise(io, o, kinds); });
  list(io, "buildings", c.buildings, 0, [&](auto& o) { serialise(io, o); });
  list(io, "trees", c.trees, 0, [&](auto& o) { serialise(io, o); });
  list(io, "woods", c.woods, 0, [&](auto& o) { serialise(io, o); });
  list(io, "plantings", c.plantings, 0, [&](auto& o) { serialise(io, o); });
  list(io, "tree rows", c.tree_rows, 0, [&](auto& o) { serialise(io, o); });
  list(io, "power corridors", c.corridors, 0, [&](auto& o) { serialise(io, o); });
  list(io, "barriers", c.barriers, 0, [&](auto& o) { serialise(io, o); });
  list(io, "lamps", c.lamps, 0, [&](auto& o) { serialise(io, o); });
  list(io, "sports fields", c.pitches, 0, [&](auto& o) { serialise(io, o); });
  list(io, "landforms", c.landforms, 0, [&](auto& o) { serialise(io, o); });
  things(io, c.things);
  list(io, "wire spans", c.wire_spans, 0, [&](auto& o) { serialise(io, o); });
  texts(io, c.texts);
  yards(io, stripped);
}

double step_of(scene::StrippedChunk& chunk) {
  PointStepProbe finder;
  serialise(finder, chunk);
  return finder.point_step_m;
}

}  // namespace

std::span<const char* const> stream_names() { return kStreamNames; }

Streams encode_chunk(const Chunk& chunk, std::uint64_t seed) {
  Writer writer;
  // codecs take their objects by reference, since readers change them
  scene::StrippedChunk stripped = scene::strip_yards(chunk, seed);
  writer.point_step_m = step_of(stripped);
  serialise(writer, stripped);
  Streams streams;
  for (std::size_t i = 0; i < kStreamNames.size(); ++i)
    if (!writer.streams[i].bytes().empty()) streams[kStreamNames[i]] = writer.streams[i].bytes();
  return streams;
}

std::optional<Chunk> decode_chunk(const Streams& streams, scene::TileKey tile, std::uint64_t seed, std::string& wrong) {
  Reader reader;
  for (const auto& [name, bytes] : streams) {
    const auto known = std::ranges::find(kStreamNames, std::string_view(name));
    if (known == kStreamNames.end()) return wrong = name, std::nullopt;
    reader.streams[static_cast<std::size_t>(known - kStreamNames.begin())].emplace(bytes);
    reader.total_bytes += bytes.size();
  }
  scene::StrippedChunk stripped;
  stripped.chunk.tile = tile;
  serialise(reader, stripped);
  for (std::size_t i = 0; i < kStreamNames.size(); ++i)
    if (reader.wrong.empty() && reader.streams[i] && !reader.streams[i]->is_finished()) reader.wrong = kStreamNames[i];
  wrong = reader.wrong;
  if (!wrong.empty()) return std::nullopt;
  return scene::restore_yards(std::move(stripped), seed);
}

}  // namespace citykiln::exporters
