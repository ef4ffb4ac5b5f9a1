// The three classes that the codecs of a chunk work on: Writer, Reader, and a probe that finds the grid step of its
// points. A chunk holds the recipes of one tile; a stream is the sequence of values of one property in a chunk.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "compiler/contract/texts/utf8.h"
#include "compiler/contract/tolerance.h"
#include "compiler/geometry/curved_chord.h"
#include "compiler/geometry/vec.h"
#include "compiler/map/locate.h"
#include "exporters/kiln/streams.h"
#include "exporters/tags_json.h"

namespace citykiln::exporters {

/// The names of the streams of a chunk, one per property, in the order of a chunk.
inline constexpr std::array kStreamNames = {
#define STREAM(name) name,
#include "exporters/kiln/chunk_streams.inc"
#undef STREAM
};

/// The number of a stream, made from its name, such as "knot height". An unknown name does not compile.
struct Stream {
  std::size_t number;
  consteval Stream(const char* name)  // NOLINT: implicit, so that names read as names
      : number(
            static_cast<std::size_t>(std::ranges::find(kStreamNames, std::string_view(name)) - kStreamNames.begin())) {
    if (number == kStreamNames.size()) throw "a name of the list";
  }
  const char* name() const { return kStreamNames[number]; }
};

/// The largest number of objects for which a reader reserves memory before it has read them.
inline constexpr std::size_t kMaxReserve = 1u << 12;
/// The largest coordinate or length. The plane extends 80 degrees of longitude from its origin: 16 000 km.
inline constexpr double kMaxCoordinate_m = 0x1p25;

/// The place of a point in the list of the chunk's points. A point that several rings and lines share is written once.
/// Rings follow shared borders forwards or backwards, so most shared points are neighbours of the last one used.
enum PointCode : std::uint64_t {
  kNewPoint,       ///< Appended to the list; its coordinates follow.
  kNextPoint,      ///< The point after the last one used.
  kPreviousPoint,  ///< The point before the last one used.
  kFirstJump,      ///< Elsewhere; the distance in the list follows.
  kCurve           ///< In lines: a curve leads to the next point. Its points between are computed, and not in the list.
};

// Points of the map are multiples of kMapStep_m. If any point of a chunk is finer, all are written in steps of
// kQuantum_m.
using map::kMapStep_m;

/// Writes values to the streams.
struct Writer {
  static constexpr bool kReads = false;
  std::array<StreamWriter, kStreamNames.size()> streams;
  std::map<Vec2, std::int64_t> known;
  std::int64_t last = -1;
  double point_step_m = kQuantum_m;

  void point(Vec2& p) {
    const auto [entry, is_new] = known.try_emplace(p, static_cast<std::int64_t>(known.size()));
    const std::int64_t step = entry->second - last;
    StreamWriter& codes = of("points");
    if (is_new) {
      codes.put(kNewPoint);
      of("x").put_delta(static_cast<std::int64_t>(std::floor(p.x / point_step_m + 0.5)));
      of("y").put_delta(static_cast<std::int64_t>(std::floor(p.y / point_step_m + 0.5)));
    } else if (step == 1 || step == -1) {
      codes.put(step == 1 ? kNextPoint : kPreviousPoint);
    } else {
      codes.put(kFirstJump);
      of("point jumps").put_signed(step);
    }
    last = entry->second;
  }

  void curve(const CurvedChord& chord) {
    of("points").put(kCurve);
    of("curve slopes").put_signed(chord.leave), of("curve slopes").put_signed(chord.arrive);
    of("curve reaches").put(chord.leave_reach), of("curve reaches").put(chord.arrive_reach);
    of("curve pieces").put(chord.pieces);
  }

  StreamWriter& of(Stream stream) { return streams[stream.number]; }
  void number(Stream name, auto& value) { of(name).put(static_cast<std::uint64_t>(value)); }
  void delta(Stream name, auto& value) { of(name).put_delta(static_cast<std::int64_t>(value)); }
  void metres(Stream name, double& value) {
    of(name).put_delta(static_cast<std::int64_t>(std::floor(value / kQuantum_m + 0.5)));
  }
  void text(Stream size, Stream bytes, std::string& value) {
    of(size).put(value.size());
    of(bytes).put_bytes(value);
  }
  void tags(Stream size, Stream bytes, const map::TagList& value) {
    std::string json = tags_text(value);
    text(size, bytes, json);
  }
  std::size_t count(Stream name, std::size_t size) {
    of(name).put(size);
    return size;
  }
};

/// Reads values from the streams. `wrong` is the name of the first stream with a value that no chunk can have, else
/// empty.
struct Reader {
  static constexpr bool kReads = true;
  std::array<std::optional<StreamReader>, kStreamNames.size()> streams;
  std::string wrong;
  std::vector<Vec2> known;
  std::int64_t last = -1;
  double point_step_m = kQuantum_m;

  void point(Vec2& p) { point_of(whole("points"), p); }

  // The point with this code.
  void point_of(std::uint64_t code, Vec2& p) {
    if (code == kNewPoint) {
      p.x = place("x", point_step_m), p.y = place("y", point_step_m);
      last = static_cast<std::int64_t>(known.size());
      known.push_back(p);
      return;
    }
    if (code > kFirstJump) return fail("points");
    const std::int64_t step = code == kNextPoint ? 1 : code == kPreviousPoint ? -1 : jump();
    const auto found = static_cast<std::uint64_t>(last) + static_cast<std::uint64_t>(step);
    if (found >= known.size()) return fail("points");
    last = static_cast<std::int64_t>(found);
    p = known[found];
  }

  CurvedChord curve() {
    CurvedChord chord{.leave = slope(), .arrive = slope(), .leave_reach = reach(), .arrive_reach = reach()};
    const std::uint64_t pieces = whole("curve pieces");
    if (pieces > kMostPieces) fail("curve pieces");
    chord.pieces = static_cast<std::uint8_t>(std::min<std::uint64_t>(pieces, kMostPieces));
    return chord;
  }
  std::int8_t slope() {
    const std::int64_t slope = checked("curve slopes", &StreamReader::get_signed);
    if (std::abs(slope) > kMostSlopeUnits) fail("curve slopes");
    return static_cast<std::int8_t>(std::clamp<std::int64_t>(slope, -kMostSlopeUnits, kMostSlopeUnits));
  }
  std::uint8_t reach() {
    const std::uint64_t reach = whole("curve reaches");
    if (reach > kWholeReach) fail("curve reaches");
    return static_cast<std::uint8_t>(std::min<std::uint64_t>(reach, kWholeReach));
  }

  StreamReader& of(Stream stream) {
    std::optional<StreamReader>& reader = streams[stream.number];
    if (!reader) fail(stream), reader.emplace();
    return *reader;
  }
  // reads a number; past the end of the stream it is zero and sets `wrong`
  template <typename T>
  T checked(Stream name, T (StreamReader::*get)()) {
    StreamReader& stream = of(name);
    const T value = (stream.*get)();
    if (!stream.good()) fail(name);
    return value;
  }
  std::uint64_t whole(Stream name) { return checked<std::uint64_t>(name, &StreamReader::get); }
  std::int64_t jump() { return checked("point jumps", &StreamReader::get_signed); }
  double place(Stream name, double step_m) {
    const double value = static_cast<double>(checked(name, &StreamReader::get_delta)) * step_m;
    if (std::abs(value) <= kMaxCoordinate_m) return value;
    fail(name);
    return 0;
  }
  void number(Stream name, auto& value) {
    using T = std::remove_reference_t<decltype(value)>;
    const std::uint64_t read = whole(name);
    value = static_cast<T>(read);
    if (static_cast<std::uint64_t>(value) != read) fail(name);
  }
  void delta(Stream name, std::int64_t& value) { value = checked(name, &StreamReader::get_delta); }
  void metres(Stream name, double& value) { value = place(name, kQuantum_m); }
  void text(Stream size, Stream bytes, std::string& value) {
    const std::uint64_t length = whole(size);
    if (length == 0) return value.clear();
    StreamReader& stream = of(bytes);
    value = stream.get_bytes(length);
    if (!stream.good() || !is_utf8(value)) fail(bytes), value.clear();
  }
  void tags(Stream size, Stream bytes, map::TagList& value) {
    std::string json;
    text(size, bytes, json);
    std::optional<map::TagList> read = tags_in(json);
    if (!read) fail(bytes);
    value = read ? std::move(*read) : map::TagList{};
  }
  // an object takes at least one byte of some stream, so a chunk has no more objects than bytes
  std::size_t total_bytes = 0;
  std::size_t count(Stream name, std::size_t) {
    const std::uint64_t size = whole(name);
    if (size <= total_bytes) return static_cast<std::size_t>(size);
    fail(name);
    return 0;
  }
  void fail(Stream name) {
    if (wrong.empty()) wrong = name.name();
  }
};

/// Finds the grid step of a chunk's points: kMapStep_m, or kQuantum_m if a point is not on that grid. Writes nothing.
struct PointStepProbe {
  static constexpr bool kReads = false;
  double point_step_m = kMapStep_m;

  void point(Vec2& p) {
    const auto fits = [](double v) { return std::floor(v / kMapStep_m) * kMapStep_m == v; };
    if (!fits(p.x) || !fits(p.y)) point_step_m = kQuantum_m;
  }
  void number(Stream, auto&) {}
  void delta(Stream, auto&) {}
  void metres(Stream, double&) {}
  void text(Stream, Stream, std::string&) {}
  void tags(Stream, Stream, const map::TagList&) {}
  std::size_t count(Stream, std::size_t size) { return size; }
};

}  // namespace citykiln::exporters
