// Memoised derivation: of shapes that differ only by a rigid motion, the first is derived and the others are copied
// from it.
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

/// Shapes whose measures differ by less count as equal: 1 µm, above rounding error and below any visible difference.
inline constexpr double kSame_m = 0x1p-20;

struct MemoEntry {
  Subtree subtree;
  bool ready = false;      ///< The entry is complete and depends only on its key and its random draws.
  std::uint32_t next = 0;  ///< 1 + index into Memo::entries of the next entry with this key and other draws; 0: none.
};

/// A 128-bit hash of everything a node's result depends on. Two different nodes collide with probability 2^-128.
struct MemoKey {
  std::uint64_t a = 0x243f6a8885a308d3u, b = 0x13198a2e03707344u;
  void add(std::int64_t word);
  void add(std::int64_t x, std::int64_t y, std::int64_t z);
  bool operator==(const MemoKey&) const = default;
};

/// A hash table from keys to 1 + the index of their first entry in Memo::entries; 0 for none. The number of slots is a
/// power of two, and at most half of them are in use. Collisions are resolved by linear probing.
struct MemoIndex {
  struct Slot {
    MemoKey key;
    std::uint32_t first = 0;
  };
  std::vector<Slot> slots = std::vector<Slot>(512);
  std::size_t taken = 0;

  /// Returns the entry of the key, and adds it if it is new. The caller must set it to a nonzero value. Valid until the
  /// next call.
  std::uint32_t& operator[](const MemoKey& key);
};

/// Statistics of a body. Its nodes are no longer recorded once that does not pay.
struct BodyRecord {
  bool never = false;  ///< Its nodes are no longer recorded.
  std::uint32_t misses = 0, hits = 0, small_ones = 0;
};

/// A node that is being recorded.
struct OpenNode {
  std::uint32_t node = 0;
  int depth = 0;
  int deepest = 0;  ///< The greatest depth of rules within the node.
  bool is_repeatable = true;
};

struct Memo {
  std::vector<MemoEntry> entries;
  MemoIndex first_of;
  /// Entries whose terminals are still in the derivation, in the order of the terminals.
  std::vector<std::uint32_t> seen;
  std::vector<RemovedTerminals> removed;
  std::vector<OpenNode> open;
  std::vector<BodyRecord> bodies;  ///< By Body::number.
};

/// The result of looking a node up, and the state before it is derived.
struct Recording {
  std::uint32_t entry = 0;  ///< 1 + index into Memo::entries; 0: the node is not recorded.
  bool known = false;       ///< The entry is complete: the node is copied instead of derived.
  SubtreeRows before;       ///< The sizes of the run's tables before the node.
};

/// Looks the node up, before any operation has changed its shape.
Recording begin_recording(Execution& execution, const Body& body);

/// Notes for the nodes being recorded that rules have reached this depth.
void note_depth(Memo& memo, int depth);

/// Copies the result in the recording's entry to the node's shape. @param recording  Its entry is known.
NodeTrace repeat(Execution& execution, const Recording& recording);

/// Records the result of a node. Recordings must end in the reverse order of their beginnings.
void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace);

/// Removes the terminals from index `first` on from the derivation. Entries that contain them keep a copy.
void remove_terminals_from(Run& run, std::size_t first);

}  // namespace citykiln::grammars
