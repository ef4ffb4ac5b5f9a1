#include "exporters/kiln/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "compiler/buildings/styles/style.h"
#include "compiler/contract/system/for_each_slot.h"
#include "compiler/contract/system/program_version.h"
#include "compiler/map/buildings/building_classes.h"
#include "compiler/map/locate.h"
#include "exporters/content_hash.h"
#include "exporters/file.h"
#include "exporters/kiln/chunk_codec.h"
#include "exporters/kiln/shown_codec.h"
#include "exporters/kiln/sky_codec.h"
#include "exporters/kiln/streams.h"
#include "exporters/kiln/surroundings_codec.h"
#include "exporters/kiln/zstd_frame.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;
using ByteSpan = std::span<const std::byte>;
// before compression or after decompression
using RawBytes = std::vector<std::uint8_t>;

constexpr char kMagic[8] = {'C', 'I', 'T', 'Y', 'K', 'I', 'L', 'N'};
constexpr std::uint16_t kMajor = 7, kMinor = 0;
constexpr const char* kLicence =
    "This manifest is a derivative database of OpenStreetMap, made available under the Open Database License (ODbL) "
    "1.0; see https://www.openstreetmap.org/copyright";
// offsets: magic, versions, size of the header's frame, then a checksum of these and of that frame
constexpr std::size_t kMajorAt = 8, kHeaderSizeAt = 12, kChecksumAt = 16, kPreamble = 24;

// FNV-1a, 64 bits: detects damage, not manipulation.
constexpr std::uint64_t kHashOfNothing = 0xcbf29ce484222325u;
std::uint64_t checksum(ByteSpan bytes, std::uint64_t hash = kHashOfNothing) {
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint8_t>(b)) * 0x100000001b3u;
  return hash;
}

// A hash of the names of all materials, classes, species, mixes and climates, since a manifest refers to them by
// number.
std::uint64_t tables_hash() {
  std::string names;
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    names += values_of(static_cast<materials::Material>(m)).name, names += ' ';
  for (int s = 0; s < static_cast<int>(map::LandCoverClass::kCount); ++s)
    names += values_of(static_cast<map::LandCoverClass>(s)).name, names += ' ';
  for (int b = 0; b < static_cast<int>(map::BuildingClass::kCount); ++b)
    names += values_of(static_cast<map::BuildingClass>(b)).name, names += ' ';
  for (int s = 0; s < static_cast<int>(buildings::Style::kCount); ++s)
    names += buildings::rule_file_of(static_cast<buildings::Style>(s)), names += ' ';
  for (int s = 0; s < static_cast<int>(plants::Species::kCount); ++s)
    names += values_of(static_cast<plants::Species>(s)).file, names += ' ';
  for (int m = 0; m < static_cast<int>(plants::PlantCommunity::kCount); ++m)
    names += name_of(species_mix_of(static_cast<plants::PlantCommunity>(m))), names += ' ';
  for (std::size_t c = 0; c < climate::kClimateClasses; ++c)
    names += name_of(static_cast<climate::ClimateClass>(c)), names += ' ';
  return checksum(std::as_bytes(std::span(names)));
}

// The sizes of all streams, then the streams.
RawBytes raw_chunk(const scene::Chunk& chunk, std::uint64_t seed) {
  Streams streams = encode_chunk(chunk, seed);
  StreamWriter sizes;
  for (const char* name : stream_names()) sizes.put(streams[name].size());
  RawBytes raw = sizes.bytes();
  for (const char* name : stream_names()) raw.insert(raw.end(), streams[name].begin(), streams[name].end());
  return raw;
}

flatbuffers::Offset<fbs::Index> index_of(flatbuffers::FlatBufferBuilder& builder, const scene::Scene& scene,
                                         std::span<const Bytes> frames) {
  StreamWriter x, y, size;
  std::vector<std::uint64_t> checksums;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    x.put_delta(scene.chunks[i].tile.x), y.put_delta(scene.chunks[i].tile.y);
    size.put(frames[i].size());
    checksums.push_back(checksum(frames[i]));
  }
  return fbs::CreateIndexDirect(builder, &x.bytes(), &y.bytes(), &size.bytes(), &checksums);
}

// Rule files, species files, or texts of things.
template <typename Text>
std::vector<flatbuffers::Offset<fbs::Rule>> rules_of(flatbuffers::FlatBufferBuilder& builder,
                                                     const std::vector<Text>& texts) {
  std::vector<flatbuffers::Offset<fbs::Rule>> offsets;
  for (const Text& each : texts) {
    const auto name = builder.CreateString(each.name), text = builder.CreateString(each.text);
    offsets.push_back(fbs::CreateRule(builder, name, text));
  }
  return offsets;
}

// Null if there are none: the header's bytes are then equal to those without the field.
flatbuffers::Offset<fbs::Surroundings> surroundings_of(flatbuffers::FlatBufferBuilder& builder,
                                                       const surroundings::Surroundings& around) {
  if (around.is_empty()) return 0;
  const SurroundingsStreams streams = encode_surroundings(around);
  return fbs::CreateSurroundingsDirect(builder, &streams.x, &streams.y, &streams.heights, &streams.covers,
                                       around.error_m, around.rms_error_m);
}

static_assert(cars::kShareStep * kFullShare == 1 && people::kPeopleStep * kFullShare == 1);

flatbuffers::Offset<fbs::Climate> climate_of(flatbuffers::FlatBufferBuilder& builder,
                                             const climate::ClimateField& field) {
  std::vector<std::uint8_t> classes, shares;
  for (const climate::ClimateNode& node : field.nodes)
    for (std::size_t i = 0; i < node.classes.size(); ++i)
      classes.push_back(static_cast<std::uint8_t>(node.classes[i])), shares.push_back(node.shares[i]);
  return fbs::CreateClimateDirect(builder, static_cast<std::uint8_t>(field.origin_class), field.first_column,
                                  field.first_row, field.columns, &classes, &shares);
}

RawBytes raw_header(const scene::Scene& scene, std::span<const Bytes> frames, const RawBytes& dictionary) {
  flatbuffers::FlatBufferBuilder builder;
  const scene::Header& h = scene.header;
  std::vector<flatbuffers::Offset<flatbuffers::String>> sources, attributions;
  for (const std::string& text : h.sources) sources.push_back(builder.CreateString(text));
  for (const std::string& text : h.attributions) attributions.push_back(builder.CreateString(text));
  const std::vector<std::int32_t> extent = {
      static_cast<std::int32_t>(h.extent.min.x), static_cast<std::int32_t>(h.extent.min.y),
      static_cast<std::int32_t>(h.extent.max.x), static_cast<std::int32_t>(h.extent.max.y)};
  const auto sky = encode_sky(builder, h.sky);
  const auto index = index_of(builder, scene, frames);
  // NaN stands for no value
  const double snow_line_m = h.snow_line_m.value_or(std::numeric_limits<double>::quiet_NaN());
  const auto rules = rules_of(builder, h.rules), species = rules_of(builder, h.species),
             things = rules_of(builder, h.things);
  const auto around = surroundings_of(builder, h.around);
  const auto climate = climate_of(builder, h.climate);
  const auto clip = encode_clip(builder, h.clip);
  builder.Finish(fbs::CreateHeaderDirect(
      builder, kVersion, tables_hash(), h.origin.lon_deg, h.origin.lat_deg, &extent, h.tile_m, h.seed,
      h.resampling_error_m, sky, &sources, &attributions, kLicence, index, dictionary.empty() ? nullptr : &dictionary,
      snow_line_m, &rules, &species, around, things.empty() ? nullptr : &things, climate, h.has_wild_slopes,
      encode_share(h.cars), h.has_street_furniture, encode_share(h.people), encode_share(h.traffic), h.shown.left_out,
      static_cast<std::uint16_t>(h.shown.wood_density * kFullShare), static_cast<std::uint8_t>(h.shown.lamps),
      encode_lit_windows(h.shown), clip.empty() ? nullptr : &clip));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

void put_little_endian(Bytes& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::byte>(value >> 8 * i));
}
std::uint64_t get_little_endian(ByteSpan bytes, std::size_t at, int size) {
  std::uint64_t value = 0;
  for (int i = 0; i < size; ++i) value |= static_cast<std::uint64_t>(bytes[at + static_cast<std::size_t>(i)]) << 8 * i;
  return value;
}

// The checksum of the first bytes and of the header's frame.
std::uint64_t header_checksum(ByteSpan beginning, ByteSpan frame) {
  return checksum(frame, checksum(beginning.first(kChecksumAt)));
}

using HeaderTexts = flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>;
std::vector<std::string> strings_of(const HeaderTexts* texts) {
  std::vector<std::string> strings;
  if (texts != nullptr)
    for (const auto* text : *texts) strings.push_back(text->str());
  return strings;
}

// The total size of texts: a FlatBuffer may refer to one text a million times.
std::size_t size_of(const HeaderTexts* texts) {
  std::size_t size = 0;
  if (texts != nullptr)
    for (const auto* text : *texts) size += text->size();
  return size;
}

using Rules = flatbuffers::Vector<flatbuffers::Offset<fbs::Rule>>;
template <typename Text>
std::vector<Text> texts_of(const Rules* rules) {
  std::vector<Text> texts;
  if (rules != nullptr)
    for (const auto* rule : *rules)
      if (rule->name() != nullptr && rule->text() != nullptr)
        texts.push_back({rule->name()->str(), rule->text()->str()});
  return texts;
}
std::size_t size_of(const Rules* rules) {
  std::size_t size = 0;
  if (rules != nullptr)
    for (const auto* rule : *rules)
      size += (rule->name() ? rule->name()->size() : 0) + (rule->text() ? rule->text()->size() : 0);
  return size;
}

bool is_whole_cells(const Box2& extent, double tile_m) {
  const auto whole = [](double v) { return std::floor(v / map::kCell_m) * map::kCell_m == v; };
  // 500 km to each side: no plane is wider
  constexpr double kWidest_m = 524288;
  return whole(extent.min.x) && whole(extent.min.y) && whole(extent.max.x) && whole(extent.max.y) &&
         extent.width() > 0 && extent.height() > 0 && extent.min.x >= -kWidest_m && extent.min.y >= -kWidest_m &&
         extent.max.x <= kWidest_m && extent.max.y <= kWidest_m && std::isfinite(tile_m) && tile_m >= map::kCell_m &&
         tile_m <= 2 * kWidest_m && whole(tile_m);
}

Error damaged_header(const std::string& name) {
  return {name, "expected a citykiln manifest, found one whose header is damaged"};
}

// Nothing where a stream ends early or late, or the values are not such as compile writes.
std::optional<surroundings::Surroundings> plain(const fbs::Surroundings& s) {
  const auto bytes = [](const flatbuffers::Vector<std::uint8_t>* stream) {
    return stream == nullptr ? std::span<const std::uint8_t>() : std::span(stream->data(), stream->size());
  };
  auto around = decode_surroundings(bytes(s.x()), bytes(s.y()), bytes(s.heights()), bytes(s.covers()));
  if (!around) return std::nullopt;
  around->error_m = s.error_m(), around->rms_error_m = s.rms_error_m();
  return surroundings::is_sound(*around) ? std::move(around) : std::nullopt;
}

// Nothing where the values are not such as compile writes.
std::optional<climate::ClimateField> plain(const fbs::Climate* c) {
  if (c == nullptr || c->classes() == nullptr || c->shares() == nullptr) return std::nullopt;
  climate::ClimateField field{.origin_class = static_cast<climate::ClimateClass>(c->own()),
                              .first_column = c->first_column(),
                              .first_row = c->first_row(),
                              .columns = c->columns(),
                              .nodes = {}};
  climate::ClimateNode node;
  const unsigned each = static_cast<unsigned>(node.shares.size());
  if (c->classes()->size() != c->shares()->size() || c->shares()->size() % each != 0) return std::nullopt;
  for (unsigned i = 0; i < c->shares()->size(); ++i) {
    node.classes[i % each] = static_cast<climate::ClimateClass>(c->classes()->Get(i));
    node.shares[i % each] = c->shares()->Get(i);
    if (i % each == each - 1) field.nodes.push_back(node);
  }
  return climate::is_sound(field) ? std::optional(std::move(field)) : std::nullopt;
}

// Converts the header to plain data and checks its values.
Result<scene::Header> plain(const fbs::Header& h, std::size_t raw_size, const std::string& name) {
  const Error damaged = damaged_header(name);
  if (h.region_m() == nullptr || h.region_m()->size() != 4 || h.sky() == nullptr ||
      size_of(h.sources()) + size_of(h.attributions()) + size_of(h.rules()) + size_of(h.species()) +
              size_of(h.things()) >
          raw_size)
    return damaged;
  scene::Header header;
  header.origin = {h.origin_lon_deg(), h.origin_lat_deg()};
  const auto& r = *h.region_m();
  header.extent = {{static_cast<double>(r[0]), static_cast<double>(r[1])},
                   {static_cast<double>(r[2]), static_cast<double>(r[3])}};
  header.tile_m = h.tile_m(), header.seed = h.seed(), header.resampling_error_m = h.resampling_error_m();
  const bool has_origin = std::abs(header.origin.lon_deg) <= 180 && std::abs(header.origin.lat_deg) <= 90;
  if (!has_origin || !is_whole_cells(header.extent, header.tile_m) || !std::isfinite(header.resampling_error_m))
    return damaged;
  std::optional<sky::Sky> sky = decode_sky(*h.sky());
  if (!sky) return damaged;
  header.sky = std::move(*sky);
  if (std::isinf(h.snow_line_m())) return damaged;
  if (!std::isnan(h.snow_line_m())) header.snow_line_m = h.snow_line_m();
  header.sources = strings_of(h.sources()), header.attributions = strings_of(h.attributions());
  header.rules = texts_of<buildings::RuleText>(h.rules());
  header.species = texts_of<plants::SpeciesText>(h.species());
  header.things = texts_of<buildings::RuleText>(h.things());
  std::optional<climate::ClimateField> climate = plain(h.climate());
  if (!climate) return damaged;
  header.climate = std::move(*climate);
  header.has_wild_slopes = h.has_wild_slopes();
  const auto cars = decode_share<cars::CarShare>(h.cars());
  const auto people = decode_share<people::PeopleShare>(h.people());
  const auto traffic = decode_share<cars::CarShare>(h.traffic());
  const std::optional<scene::Shown> shown = decode_shown(h);
  std::optional<scene::Clip> clip = decode_clip(h);
  if (!cars || !people || !traffic || !shown || !clip) return damaged;
  header.cars = *cars, header.people = *people, header.traffic = *traffic;
  header.shown = *shown, header.clip = std::move(*clip);
  header.has_street_furniture = h.has_street_furniture();
  if (h.around() == nullptr) return header;
  std::optional<surroundings::Surroundings> around = plain(*h.around());
  if (!around) return damaged;
  header.around = std::move(*around);
  return header;
}

// The streams of a chunk, or nothing where their sizes do not add up.
std::optional<Streams> streams_of(std::span<const std::uint8_t> raw) {
  const auto names = stream_names();
  StreamReader reader(raw);
  std::vector<std::uint64_t> sizes(names.size());
  for (std::uint64_t& size : sizes) size = reader.get();
  if (!reader.good()) return std::nullopt;
  std::span<const std::uint8_t> rest = raw.last(reader.remaining());
  Streams streams;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (sizes[i] > rest.size()) return std::nullopt;
    const auto stream = rest.first(static_cast<std::size_t>(sizes[i]));
    streams[names[i]].assign(stream.begin(), stream.end());
    rest = rest.subspan(stream.size());
  }
  return rest.empty() ? std::optional(std::move(streams)) : std::nullopt;
}

struct Entry {
  scene::TileKey tile;
  std::uint64_t offset = 0, size = 0, checksum = 0;
};

std::string where_of(const std::string& name, scene::TileKey tile) {
  return fmt::format("{}, tile {}_{}", name, tile.x, tile.y);
}

// Decodes one chunk. Its bytes are inside the body, as check_index has found.
Result<scene::Chunk> chunk_of(ByteSpan body, const Entry& entry, const UnpackingDictionary& dictionary,
                              std::uint64_t seed, const std::string& name) {
  const std::string where = where_of(name, entry.tile);
  const ByteSpan frame = body.subspan(entry.offset, entry.size);
  if (checksum(frame) != entry.checksum)
    return Error{where, "expected the checksum that the header states, found another: the file is damaged"};
  const auto raw = unpacked(frame, dictionary, where);
  if (!raw) return raw.error();
  const auto streams = streams_of(*raw);
  if (!streams) return Error{where, "expected as many streams as this format has, each of its stated size"};
  std::string wrong;
  auto chunk = decode_chunk(*streams, entry.tile, seed, wrong);
  if (!chunk) return Error{where, "expected sound values in \"" + wrong + "\""};
  return std::move(*chunk);
}

StreamReader reader_of(const flatbuffers::Vector<std::uint8_t>* stream) {
  return stream == nullptr ? StreamReader() : StreamReader({stream->data(), stream->size()});
}

// Converts the index to plain data; nothing where a stream ends early or late, or holds a number beyond its type.
std::optional<std::vector<Entry>> entries_of(const fbs::Index* index) {
  if (index == nullptr || index->checksum() == nullptr) return std::nullopt;
  StreamReader x = reader_of(index->x()), y = reader_of(index->y()), size = reader_of(index->size());
  using Coordinate = std::numeric_limits<std::int32_t>;
  const auto fits = [](std::int64_t v) { return v >= Coordinate::min() && v <= Coordinate::max(); };
  std::vector<Entry> entries;
  std::uint64_t offset = 0;
  for (const std::uint64_t checksum : *index->checksum()) {
    const std::int64_t column = x.get_delta(), row = y.get_delta();
    if (!fits(column) || !fits(row)) return std::nullopt;
    const scene::TileKey tile{static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)};
    entries.push_back({tile, offset, size.get(), checksum});
    // check_index detects sizes whose sum overflows before their offsets are used
    offset += entries.back().size;
  }
  if (!x.is_finished() || !y.is_finished() || !size.is_finished()) return std::nullopt;
  return entries;
}

// Checks the index: every tile once, in order, inside the region, its bytes in the file, and no bytes after the last.
Result<Done> check_index(std::span<const Entry> entries, const scene::Header& header, std::size_t body_size,
                         const std::string& name) {
  std::optional<scene::TileKey> last;
  std::uint64_t end = 0;
  for (const Entry& entry : entries) {
    const std::string where = where_of(name, entry.tile);
    if (last && entry.tile <= *last) return Error{where, "expected each tile once, in the order of x, then y"};
    const Box2 box = scene::box_of(header, entry.tile);
    if (box.width() <= 0 || box.height() <= 0) return Error{where, "expected tiles inside the region"};
    if (entry.size > body_size - end) return Error{where, "expected its bytes, found the end of the file"};
    last = entry.tile, end += entry.size;
  }
  if (end != body_size) return Error{name, "expected the end of the file behind the last tile"};
  return Done{};
}

// Null where the header has none.
Result<UnpackingDictionary> unpacking_dictionary_of(const fbs::Header& h, const std::string& name) {
  if (h.dictionary() == nullptr) return UnpackingDictionary();
  auto dictionary = unpacking_dictionary({h.dictionary()->data(), h.dictionary()->size()});
  if (dictionary == nullptr) return Error{name, "expected a zstd dictionary in the header, found damage in it"};
  return dictionary;
}

// The error of a manifest that this program cannot read: it names the version that made it, if the header states that,
// and what to do.
Error made_by_another(const std::string& name, ByteSpan frame, const std::string& difference) {
  const auto raw = unpacked(frame, nullptr, name);
  std::string version;
  if (raw) {
    flatbuffers::Verifier verifier(raw->data(), raw->size());
    if (verifier.VerifyBuffer<fbs::AnyHeader>(nullptr))
      if (const auto* text = flatbuffers::GetRoot<fbs::AnyHeader>(raw->data())->generator_version())
        version.append(" ").append(text->str());
  }
  return {name,
          fmt::format("{}: made by citykiln{}, and this is {}; compile the map again (citykiln compile MAP -o OUT), "
                      "or bake it with that version",
                      difference, version, kVersion)};
}

// The frame of the header, after checks of magic number, version, size and checksum.
Result<ByteSpan> header_frame(ByteSpan bytes, const std::string& name) {
  if (bytes.size() < kPreamble || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    return Error{name, "expected a citykiln manifest, which begins with CITYKILN"};
  const std::uint64_t major = get_little_endian(bytes, kMajorAt, 2), size = get_little_endian(bytes, kHeaderSizeAt, 4);
  const ByteSpan frame = bytes.subspan(kPreamble, std::min<std::uint64_t>(size, bytes.size() - kPreamble));
  if (major != kMajor)
    return made_by_another(name, frame, fmt::format("has manifest format {}, expected {}", major, kMajor));
  if (size > frame.size()) return Error{name, "expected the header, found the end of the file"};
  if (header_checksum(bytes, frame) != get_little_endian(bytes, kChecksumAt, 8)) return damaged_header(name);
  return frame;
}

bool is_wanted(std::span<const scene::TileKey> only, scene::TileKey tile) {
  return only.empty() || std::find(only.begin(), only.end(), tile) != only.end();
}

// Decodes the chunks of `only`, or all of them. The index has passed check_index.
Result<std::vector<scene::Chunk>> chunks_of(ByteSpan body, std::span<const Entry> entries,
                                            const UnpackingDictionary& dictionary, std::uint64_t seed,
                                            const std::string& name, std::span<const scene::TileKey> only) {
  std::vector<scene::Chunk> chunks;
  for (const Entry& entry : entries) {
    if (!is_wanted(only, entry.tile)) continue;
    auto chunk = chunk_of(body, entry, dictionary, seed, name);
    if (!chunk) return chunk.error();
    chunks.push_back(std::move(*chunk));
  }
  for (const scene::TileKey tile : only)
    if (std::none_of(chunks.begin(), chunks.end(), [&](const auto& c) { return c.tile == tile; }))
      return Error{name, fmt::format("has no tile {}_{}", tile.x, tile.y)};
  return chunks;
}

// The parts of a manifest that are needed to read its chunks.
struct ReadHeader {
  scene::Header header;
  std::vector<Entry> entries;
  UnpackingDictionary dictionary;
  ByteSpan body;
};

Result<ReadHeader> read_header(ByteSpan bytes, const std::string& name) {
  const auto frame = header_frame(bytes, name);
  if (!frame) return frame.error();
  const auto raw = unpacked(*frame, nullptr, name + ", header");
  if (!raw) return raw.error();
  flatbuffers::Verifier verifier(raw->data(), raw->size());
  if (!verifier.VerifyBuffer<fbs::Header>(nullptr)) return damaged_header(name);
  const fbs::Header& h = *flatbuffers::GetRoot<fbs::Header>(raw->data());
  if (h.tables_hash() != tables_hash())
    return made_by_another(name, *frame, "has other materials, classes or species than this program");
  auto header = plain(h, raw->size(), name);
  if (!header) return header.error();
  auto entries = entries_of(h.index());
  if (!entries) return damaged_header(name);
  const ByteSpan body = bytes.subspan(kPreamble + frame->size());
  if (const auto index = check_index(*entries, *header, body.size(), name); !index) return index.error();
  auto dictionary = unpacking_dictionary_of(h, name);
  if (!dictionary) return dictionary.error();
  return ReadHeader{std::move(*header), std::move(*entries), std::move(*dictionary), body};
}

}  // namespace

Bytes encode_manifest(const scene::Scene& scene, int threads) {
  assert(std::ranges::is_sorted(scene.chunks, {}, &scene::Chunk::tile));
  const std::size_t count = scene.chunks.size();
  const auto raws = for_each_slot<RawBytes>(
      count, threads, [&](std::size_t i) { return raw_chunk(scene.chunks[i], scene.header.seed); });
  const RawBytes dictionary = train_dictionary(raws);
  const PackingDictionary ready = packing_dictionary(dictionary);
  const auto frames = for_each_slot<Bytes>(count, threads, [&](std::size_t i) { return packed(raws[i], ready); });
  const Bytes header = packed(raw_header(scene, frames, dictionary), nullptr);
  Bytes bytes;
  for (const char c : kMagic) bytes.push_back(static_cast<std::byte>(c));
  put_little_endian(bytes, kMajor, 2), put_little_endian(bytes, kMinor, 2), put_little_endian(bytes, header.size(), 4);
  put_little_endian(bytes, header_checksum(bytes, header), 8);
  bytes.insert(bytes.end(), header.begin(), header.end());
  for (const Bytes& frame : frames) bytes.insert(bytes.end(), frame.begin(), frame.end());
  return bytes;
}

std::vector<StreamSize> stream_sizes_of(const scene::Scene& scene) {
  std::vector<StreamSize> sizes;
  for (const char* name : stream_names()) sizes.push_back({name, 0, 0});
  for (const scene::Chunk& chunk : scene.chunks) {
    Streams streams = encode_chunk(chunk, scene.header.seed);
    for (StreamSize& size : sizes) {
      const std::vector<std::uint8_t>& stream = streams[size.name];
      if (stream.empty()) continue;
      size.raw_bytes += stream.size();
      size.packed_bytes += packed(stream, nullptr).size();
    }
  }
  std::erase_if(sizes, [](const StreamSize& size) { return size.raw_bytes == 0; });
  return sizes;
}

Result<Done> check_header(ByteSpan bytes, const std::string& name) {
  const auto read = read_header(bytes, name);
  if (!read) return read.error();
  return Done{};
}

Result<scene::Scene> decode_manifest(ByteSpan bytes, const std::string& name, std::span<const scene::TileKey> only) {
  auto read = read_header(bytes, name);
  if (!read) return read.error();
  auto chunks = chunks_of(read->body, read->entries, read->dictionary, read->header.seed, name, only);
  if (!chunks) return chunks.error();
  return scene::Scene{std::move(read->header), std::move(*chunks)};
}

std::uint64_t hash_of(const scene::Header& header) {
  const RawBytes raw = raw_header({header, {}}, {}, {});
  return content_hash(std::as_bytes(std::span(raw)));
}

std::uint64_t hash_of(const scene::Chunk& chunk, std::uint64_t seed) {
  const RawBytes raw = raw_chunk(chunk, seed);
  return content_hash(std::as_bytes(std::span(raw)));
}

Result<scene::Scene> read_manifest(const std::string& path, std::span<const scene::TileKey> only) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return decode_manifest(*bytes, path, only);
}

}  // namespace citykiln::exporters
