// Memoised derivation: of shapes that differ by a rigid motion only, the first is derived and the others are copies.
//
//   ┌──┬──┬──┐      A node becomes a memo entry if its result depends only on its key: body, arguments, the shape in
//   │A │A'│A'│      coordinates of its scope, the direction of the vertical, appearance. Position, neighbours, warnings
//   └──┴──┴──┘      and random numbers used as values exclude a node, but not the nodes below it. Random numbers that
//                   only select between branches do not: each outcome is an entry, with the intervals of its draws.
#pragma once

#include <cstdint>
#include <vector>

#include "grammars/derivation/subtree_copy.h"

namespace citykiln::grammars {

struct Body;
struct Run;
struct Execution;

/// Shapes whose measures differ by less are equal: 1 µm, above rounding error and below any visible difference.
inline constexpr double kSame_m = 0x1p-20;

struct MemoEntry {
  Subtree subtree;
  bool ready = false;  ///< It is complete, and depends on nothing but its key and its draws.
  std::uint32_t next =
      0;  ///< 1 + index into Memo::entries of the next with the same key and other draws; 0 for the last.
};

/// A hash of all that a node depends on: 128 bits, so that two different nodes of a building collide with chance
/// 2^-128.
struct MemoKey {
  std::uint64_t a = 0x243f6a8885a308d3u, b = 0x13198a2e03707344u;
  void add(std::int64_t word);
  void add(std::int64_t x, std::int64_t y, std::int64_t z);
  bool operator==(const MemoKey&) const = default;
};

/// A hash table from keys to 1 + the index of their first entry in Memo::entries; 0 for none. The number of slots is a
/// power of two, at most half of them are in use. Collisions probe linearly.
struct MemoIndex {
  struct Slot {
    MemoKey key;
    std::uint32_t first = 0;
  };
  std::vector<Slot> slots = std::vector<Slot>(512);
  std::size_t taken = 0;

  /// The entry of the key, added if it is new. The caller has to make it nonzero. Valid until the next call.
  std::uint32_t& operator[](const MemoKey& key);
};

/// Statistics of a body, by which recording stops where it does not pay.
struct BodyRecord {
  bool never = false;  ///< Its nodes are not recorded any more.
  std::uint32_t misses = 0, hits = 0, small_ones = 0;
};

/// A node being recorded.
struct OpenNode {
  std::uint32_t node = 0;
  int depth = 0;
  int deepest = 0;  ///< The greatest depth of rules in it.
  bool is_repeatable = true;
};

struct Memo {
  std::vector<MemoEntry> entries;
  MemoIndex first_of;
  std::vector<std::uint32_t> seen;  ///< Entries whose terminals are still in the derivation, in their order.
  std::vector<RemovedTerminals> removed;
  std::vector<OpenNode> open;
  std::vector<BodyRecord> bodies;  ///< By Body::number.
};

/// The start of a node.
struct Recording {
  std::uint32_t entry = 0;  ///< 1 + index into Memo::entries; 0: the node is not recorded.
  bool known = false;       ///< The entry is complete: the node is copied instead of derived.
  SubtreeRows before;       ///< The ends of the tables of the run.
};

/// Looks the node up, before any operation has changed its shape.
Recording begin_recording(Execution& execution, const Body& body);

/// Tells the node being recorded that rules have reached this depth.
void note_depth(Memo& memo, int depth);

/// Copies the recording's entry to the node's shape. @param recording  Of a known entry.
NodeTrace repeat(Execution& execution, const Recording& recording);

/// Records the result of the node. Recordings end in the reverse order of their beginnings.
void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace);

/// Removes the terminals from index `first` on from the derivation. Entries keep theirs.
void remove_terminals_from(Run& run, std::size_t first);

}  // namespace citykiln::grammars
