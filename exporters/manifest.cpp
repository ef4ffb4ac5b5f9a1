#include "exporters/manifest.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "compiler/contract/for_each_slot.h"
#include "compiler/map/locate.h"
#include "exporters/chunk_codec.h"
#include "exporters/file.h"
#include "exporters/manifest_generated.h"

namespace citykiln::exporters {
namespace {

using Bytes = std::vector<std::byte>;
using ByteSpan = std::span<const std::byte>;

constexpr char kMagic[8] = {'C', 'I', 'T', 'Y', 'K', 'I', 'L', 'N'};
constexpr std::uint16_t kMajor = 1, kMinor = 0;
constexpr const char* kExpanderVersion = "0.1.0";
constexpr const char* kLicence =
    "This manifest is a derivative database of OpenStreetMap, made available under the Open Database License (ODbL) "
    "1.0; see https://www.openstreetmap.org/copyright";
// Beyond 17 zstd takes twice the time for a few bytes in a hundred.
constexpr int kZstdLevel = 17;
// magic, size of the header, checksum of the header
constexpr std::size_t kPreamble = 8 + 8 + 8;
// No tile of a city comes near this; a file that asks for more is not believed.
constexpr std::uint64_t kMostRawBytes = 1u << 28;
constexpr std::size_t kMostHeaderBytes = 1u << 28;

// FNV-1a, 64 bits: against rot, not against malice.
std::uint64_t checksum(ByteSpan bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint8_t>(b)) * 0x100000001b3u;
  return hash;
}

// Of the names of all materials and surface classes: a manifest numbers them.
std::uint64_t tables_hash() {
  std::string names;
  for (int m = 0; m < static_cast<int>(materials::Material::kCount); ++m)
    names += values_of(static_cast<materials::Material>(m)).name, names += ' ';
  for (int s = 0; s < static_cast<int>(map::SurfaceClass::kCount); ++s)
    names += values_of(static_cast<map::SurfaceClass>(s)).name, names += ' ';
  return checksum(std::as_bytes(std::span(names)));
}

Bytes squeezed(ByteSpan raw) {
  Bytes bytes(ZSTD_compressBound(raw.size()));
  bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), kZstdLevel));
  return bytes;
}

struct Frame {
  Bytes bytes;
  std::size_t raw_size = 0;
};

Frame frame_of(const scene::Chunk& chunk) {
  flatbuffers::FlatBufferBuilder builder;
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint8_t> all;
  Streams streams = encode_chunk(chunk);
  for (const char* name : stream_names()) {
    sizes.push_back(static_cast<std::uint32_t>(streams[name].size()));
    all.insert(all.end(), streams[name].begin(), streams[name].end());
  }
  builder.Finish(fbs::CreateChunkDirect(builder, &sizes, &all));
  const ByteSpan raw = std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize()));
  return {squeezed(raw), raw.size()};
}

flatbuffers::Offset<fbs::Sky> sky_of(flatbuffers::FlatBufferBuilder& builder, const sky::Sky& sky) {
  // steps of 2^-20 are exact as integers
  const std::vector<std::int64_t> to_sun = {std::llround(sky.to_sun.x * 0x1p20), std::llround(sky.to_sun.y * 0x1p20),
                                            std::llround(sky.to_sun.z * 0x1p20)};
  const auto time = builder.CreateString(sky.time);
  return fbs::CreateSky(builder, time, builder.CreateVector(to_sun), sky.turbidity);
}

Bytes header_of(const scene::Scene& scene, std::span<const Frame> frames) {
  flatbuffers::FlatBufferBuilder builder;
  const scene::Header& h = scene.header;
  std::vector<flatbuffers::Offset<fbs::ChunkEntry>> entries;
  std::uint64_t offset = 0;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const Frame& f = frames[i];
    entries.push_back(fbs::CreateChunkEntry(builder, scene.chunks[i].tile.x, scene.chunks[i].tile.y, offset,
                                            f.bytes.size(), f.raw_size, checksum(f.bytes)));
    offset += f.bytes.size();
  }
  std::vector<flatbuffers::Offset<flatbuffers::String>> sources, attributions;
  for (const std::string& text : h.sources) sources.push_back(builder.CreateString(text));
  for (const std::string& text : h.attributions) attributions.push_back(builder.CreateString(text));
  const std::vector<std::int32_t> region = {
      static_cast<std::int32_t>(h.region.min.x), static_cast<std::int32_t>(h.region.min.y),
      static_cast<std::int32_t>(h.region.max.x), static_cast<std::int32_t>(h.region.max.y)};
  const auto sky = sky_of(builder, h.sky);
  builder.Finish(fbs::CreateHeaderDirect(builder, kMajor, kMinor, kExpanderVersion, tables_hash(), h.origin.lon_deg,
                                         h.origin.lat_deg, &region, h.tile_m, h.seed, h.resampling_error_m, sky,
                                         &sources, &attributions, kLicence, &entries));
  const ByteSpan raw = std::as_bytes(std::span(builder.GetBufferPointer(), builder.GetSize()));
  return {raw.begin(), raw.end()};
}

void put_u64(Bytes& bytes, std::uint64_t value) {
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::byte>(value >> 8 * i));
}
std::uint64_t get_u64(ByteSpan bytes) {
  std::uint64_t value = 0;
  for (int i = 0; i < 8; ++i) value |= static_cast<std::uint64_t>(bytes[static_cast<std::size_t>(i)]) << 8 * i;
  return value;
}

std::vector<std::string> strings_of(const flatbuffers::Vector<flatbuffers::Offset<flatbuffers::String>>* texts) {
  std::vector<std::string> strings;
  if (texts != nullptr)
    for (const auto* text : *texts) strings.push_back(text->str());
  return strings;
}

bool is_whole_cells(const Box2& region, double tile_m) {
  const auto whole = [](double v) { return std::floor(v / map::kCell_m) * map::kCell_m == v; };
  // 500 km on a side: no plane is wider
  constexpr double kWidest_m = 524288;
  return whole(region.min.x) && whole(region.min.y) && whole(region.max.x) && whole(region.max.y) &&
         region.width() > 0 && region.height() > 0 && region.min.x >= -kWidest_m && region.min.y >= -kWidest_m &&
         region.max.x <= kWidest_m && region.max.y <= kWidest_m && std::isfinite(tile_m) && tile_m >= map::kCell_m &&
         tile_m <= 2 * kWidest_m && whole(tile_m);
}

// The header as plain data, or what is wrong with it.
Result<scene::Header> plain(const fbs::Header& h, const std::string& name) {
  const Error damaged{name, "expected a citykiln manifest, found one whose header is damaged"};
  if (h.region_m() == nullptr || h.region_m()->size() != 4 || h.sky() == nullptr || h.sky()->to_sun() == nullptr ||
      h.sky()->to_sun()->size() != 3 || h.chunks() == nullptr)
    return damaged;
  scene::Header header;
  header.origin = {h.origin_lon_deg(), h.origin_lat_deg()};
  const auto& r = *h.region_m();
  header.region = {{static_cast<double>(r[0]), static_cast<double>(r[1])},
                   {static_cast<double>(r[2]), static_cast<double>(r[3])}};
  header.tile_m = h.tile_m(), header.seed = h.seed(), header.resampling_error_m = h.resampling_error_m();
  const bool has_origin = std::abs(header.origin.lon_deg) <= 180 && std::abs(header.origin.lat_deg) <= 90;
  if (!has_origin || !is_whole_cells(header.region, header.tile_m) || !std::isfinite(header.resampling_error_m))
    return damaged;
  const auto& s = *h.sky();
  if (s.time() != nullptr) header.sky.time = s.time()->str();
  header.sky.to_sun = {(*s.to_sun())[0] * 0x1p-20, (*s.to_sun())[1] * 0x1p-20, (*s.to_sun())[2] * 0x1p-20};
  header.sky.turbidity = s.turbidity();
  const double length2 = dot(header.sky.to_sun, header.sky.to_sun);
  if (!(length2 > 0.99 && length2 < 1.01) || !(header.sky.turbidity >= 1 && header.sky.turbidity <= 20)) return damaged;
  header.sources = strings_of(h.sources()), header.attributions = strings_of(h.attributions());
  return header;
}

// The streams of a chunk, or nothing where their sizes do not add up.
std::optional<Streams> streams_of(const fbs::Chunk& chunk) {
  const auto names = stream_names();
  if (chunk.sizes() == nullptr || chunk.bytes() == nullptr || chunk.sizes()->size() != names.size())
    return std::nullopt;
  const std::span<const std::uint8_t> all(chunk.bytes()->data(), chunk.bytes()->size());
  Streams streams;
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    const std::size_t size = chunk.sizes()->Get(i);
    if (size > all.size() - at) return std::nullopt;
    const auto stream = all.subspan(at, size);
    streams[names[i]].assign(stream.begin(), stream.end());
    at += size;
  }
  return at == all.size() ? std::optional(std::move(streams)) : std::nullopt;
}

// The bytes of one chunk, unpacked and checked; check_index has found them inside the body.
Result<scene::Chunk> chunk_of(ByteSpan body, const fbs::ChunkEntry& entry, const std::string& name) {
  const std::string where = fmt::format("{}, tile {}_{}", name, entry.x(), entry.y());
  if (entry.raw_size() > kMostRawBytes)
    return Error{where, fmt::format("expected at most {} bytes unpacked, found {}", kMostRawBytes, entry.raw_size())};
  const ByteSpan packed = body.subspan(entry.offset(), entry.size());
  if (checksum(packed) != entry.checksum())
    return Error{where, "expected the checksum that the header states, found another: the file is damaged"};
  if (ZSTD_getFrameContentSize(packed.data(), packed.size()) != entry.raw_size())
    return Error{where, "expected a zstd frame of the stated size"};
  std::vector<std::uint8_t> raw(entry.raw_size());
  if (ZSTD_decompress(raw.data(), raw.size(), packed.data(), packed.size()) != raw.size())
    return Error{where, "expected a zstd frame, found damage in it"};
  flatbuffers::Verifier verifier(raw.data(), raw.size());
  if (!verifier.VerifyBuffer<fbs::Chunk>(nullptr))
    return Error{where, "expected a chunk's tables, found damage in them"};
  const auto streams = streams_of(*flatbuffers::GetRoot<fbs::Chunk>(raw.data()));
  if (!streams) return Error{where, "expected as many streams as this format has, each of its stated size"};
  std::string wrong;
  auto chunk = decode_chunk(*streams, {entry.x(), entry.y()}, wrong);
  if (!chunk) return Error{where, "expected sound values in \"" + wrong + "\""};
  return std::move(*chunk);
}

// The index as a whole: every tile once, in order, inside the region, its bytes right behind those of the tile before,
// and nothing behind the last.
Result<Done> check_index(const fbs::Header& h, const scene::Header& header, std::size_t body_size,
                         const std::string& name) {
  std::optional<scene::TileKey> last;
  std::uint64_t end = 0;
  for (const auto* entry : *h.chunks()) {
    const scene::TileKey tile{entry->x(), entry->y()};
    const std::string where = fmt::format("{}, tile {}_{}", name, tile.x, tile.y);
    if (last && tile <= *last) return Error{where, "expected each tile once, in the order of x, then y"};
    const Box2 box = scene::box_of(header, tile);
    if (box.width() <= 0 || box.height() <= 0) return Error{where, "expected tiles inside the region"};
    if (entry->offset() != end) return Error{where, "expected its bytes right behind those of the tile before"};
    if (entry->size() > body_size - end) return Error{where, "expected its bytes, found the end of the file"};
    last = tile, end += entry->size();
  }
  if (end != body_size) return Error{name, "expected the end of the file behind the last tile"};
  return Done{};
}

bool is_wanted(std::span<const scene::TileKey> only, scene::TileKey tile) {
  return only.empty() || std::find(only.begin(), only.end(), tile) != only.end();
}

}  // namespace

Bytes encode_manifest(const scene::Scene& scene, int threads) {
  const auto frames =
      for_each_slot<Frame>(scene.chunks.size(), threads, [&](std::size_t i) { return frame_of(scene.chunks[i]); });
  const Bytes header = header_of(scene, frames);
  Bytes bytes;
  for (const char c : kMagic) bytes.push_back(static_cast<std::byte>(c));
  put_u64(bytes, header.size());
  put_u64(bytes, checksum(header));
  bytes.insert(bytes.end(), header.begin(), header.end());
  for (const Frame& frame : frames) bytes.insert(bytes.end(), frame.bytes.begin(), frame.bytes.end());
  return bytes;
}

Result<scene::Scene> decode_manifest(ByteSpan bytes, const std::string& name, std::span<const scene::TileKey> only) {
  if (bytes.size() < kPreamble || std::memcmp(bytes.data(), kMagic, sizeof kMagic) != 0)
    return Error{name, "expected a citykiln manifest, which begins with CITYKILN"};
  const std::uint64_t header_size = get_u64(bytes.subspan(8));
  if (header_size > bytes.size() - kPreamble || header_size > kMostHeaderBytes)
    return Error{name, "expected the header, found the end of the file"};
  // a copy, so that it is aligned
  const ByteSpan header_span = bytes.subspan(kPreamble, header_size);
  const auto* first = reinterpret_cast<const std::uint8_t*>(header_span.data());
  const std::vector<std::uint8_t> raw(first, first + header_size);
  flatbuffers::Verifier verifier(raw.data(), raw.size());
  if (checksum(header_span) != get_u64(bytes.subspan(16)) || !verifier.VerifyBuffer<fbs::Header>(nullptr))
    return Error{name, "expected a citykiln manifest, found one whose header is damaged"};
  const fbs::Header& h = *flatbuffers::GetRoot<fbs::Header>(raw.data());
  if (h.format_major() != kMajor)
    return Error{name, fmt::format("expected format {}, found {}: made by another citykiln", kMajor, h.format_major())};
  if (h.tables_hash() != tables_hash())
    return Error{name, "expected this version's materials and surface classes, found others: made by another citykiln"};
  auto header = plain(h, name);
  if (!header) return header.error();
  scene::Scene scene{*header, {}};
  const ByteSpan body = bytes.subspan(kPreamble + header_size);
  if (const auto index = check_index(h, *header, body.size(), name); !index) return index.error();
  for (const auto* entry : *h.chunks()) {
    if (!is_wanted(only, {entry->x(), entry->y()})) continue;
    auto chunk = chunk_of(body, *entry, name);
    if (!chunk) return chunk.error();
    scene.chunks.push_back(std::move(*chunk));
  }
  for (const scene::TileKey tile : only)
    if (std::none_of(scene.chunks.begin(), scene.chunks.end(), [&](const auto& c) { return c.tile == tile; }))
      return Error{name, fmt::format("has no tile {}_{}", tile.x, tile.y)};
  return scene;
}

Result<Done> write_manifest(const scene::Scene& scene, const std::string& path, int threads) {
  return write_file(path, encode_manifest(scene, threads));
}

Result<scene::Scene> read_manifest(const std::string& path, std::span<const scene::TileKey> only) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  return decode_manifest(*bytes, path, only);
}

}  // namespace citykiln::exporters
