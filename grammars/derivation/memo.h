// Memoised derivation: of shapes that are the same but for a motion, the first is derived and the others are its
// copies.
//
//   ┌──┬──┬──┐      A node is a pattern if what it became depends on nothing but its key: its body and arguments, its
//   │A │A'│A'│      shape as its scope sees it, which way is up, its look. The place in the city, neighbours, messages
//   └──┴──┴──┘      and numbers out of the dice make it none; then the nodes below it may be. Where the dice only
//                   choose between ways to go on, each way is a pattern of its own, known by what has to be thrown.
#pragma once

#include <cstdint>
#include <vector>

#include "grammars/derivation/subtree_copy.h"

namespace citykiln::grammars {

struct Body;
struct Run;
struct Execution;

/// Shapes whose measures differ by less count as the same. Far above rounding, far below what one sees.
inline constexpr double kSame_m = 0x1p-20;

struct MemoEntry {
  Subtree pattern;
  bool ready = false;      ///< It has been derived, and depends on nothing but its key and its throws.
  std::uint32_t next = 0;  ///< 1 + where Memo::entries has the same shape, as other dice fell; 0 for the last.
};

/// 128 bits for all that a node depends on: two kinds of nodes of one building have the same with chance 2^-128.
struct MemoKey {
  std::uint64_t a = 0x243f6a8885a308d3u, b = 0x13198a2e03707344u;
  void add(std::int64_t word);
  void add(std::int64_t x, std::int64_t y, std::int64_t z);
  bool operator==(const MemoKey&) const = default;
};

/// By key, 1 + where Memo::entries has the first of them; 0 for none. Slots are 2^n, at most half of them taken.
struct MemoIndex {
  struct Slot {
    MemoKey key;
    std::uint32_t first = 0;
  };
  std::vector<Slot> slots = std::vector<Slot>(512);
  std::size_t taken = 0;

  /// The key's own, now if not before. Until the next call.
  std::uint32_t& operator[](const MemoKey& key);
};

/// How often a body's nodes were worth a note.
struct BodyRecord {
  bool never = false;
  std::uint32_t misses = 0, hits = 0, small_ones = 0;
};

/// A node under way that may become a pattern.
struct OpenNode {
  std::uint32_t birth = 0;
  int depth = 0;
  int deepest = 0;  ///< Of the rules in it.
  bool repeats = true;
};

struct Memo {
  std::vector<MemoEntry> entries;
  MemoIndex first_of;
  std::vector<std::uint32_t> seen;  ///< Of `entries`, those whose terminals are the derivation's, in their order.
  std::vector<RemovedTerminals> cut_away;
  std::vector<OpenNode> open;
  std::vector<BodyRecord> bodies;  ///< By Body::number.
};

/// A node that begins.
struct Recording {
  std::uint32_t entry = 0;  ///< 1 + where Memo::entries has it; 0: the node is not noted.
  bool known = false;       ///< There is a pattern; the node need not be derived.
  SubtreeRows before;       ///< Where the tables of the run ended.
};

/// Looks the node up, before anything has been done with its shape.
Recording begin_recording(Execution& execution, const Body& body);

/// What is under way has come as deep as this.
void came_to(Memo& memo, int depth);

/// Makes of the shape what the first one of the recording's entry was made to.
NodeTrace repeat(Execution& execution, const Recording& recording);

/// Notes what the node has become. Recordings end in the reverse order of their beginnings.
void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace);

/// Takes the terminals from `first` on out of the derivation; patterns keep theirs.
void cut_away_from(Run& run, std::size_t first);

}  // namespace citykiln::grammars
