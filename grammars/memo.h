// Memoised derivation: of shapes that are the same but for a motion, the first is derived and the others are its
// copies.
//
//   ┌──┬──┬──┐      A node is a pattern if what it became depends on nothing but its key: its body and arguments, its
//   │A │A'│A'│      shape as its scope sees it, which way is up, its look. The place in the city, neighbours, messages
//   └──┴──┴──┘      and numbers out of the dice make it none; then the nodes below it may be. Where the dice only
//                   choose between ways to go on, each way is a pattern of its own, known by what has to be thrown.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "grammars/pattern.h"

namespace citykiln::grammars {

struct Run;
struct Execution;

/// Shapes whose measures differ by less count as the same. Far above rounding, far below what one sees.
inline constexpr double kSame_m = 0x1p-20;

enum class MemoState : std::uint8_t {
  kUnderWay,  ///< Being derived.
  kSeen,      ///< Derived once: `made` says where.
  kLost,      ///< Derived, but what it made was cut away with what is around it.
  kPattern    ///< Ready to be copied.
};

struct MemoEntry {
  MemoState state = MemoState::kUnderWay;
  Shape shape;  ///< The first one.
  Made made;
  Throws throws;  ///< As the dice fell.
  Pattern pattern;
};

/// All that became of shapes that are the same, as their dice fell.
using MemoVariants = std::vector<std::unique_ptr<MemoEntry>>;

using MemoKey = std::vector<std::int64_t>;

/// FNV-1a over whole words, finished as SplitMix64 is.
struct MemoKeyHash {
  std::size_t operator()(const MemoKey& key) const;
};

/// How often a body's nodes were worth a note.
struct BodyRecord {
  bool never = false;
  std::uint32_t misses = 0, hits = 0, small_ones = 0;
};

/// A node under way that may become a pattern.
struct OpenNode {
  std::uint32_t birth = 0;
  bool repeats = true;
};

struct Memo {
  std::unordered_map<MemoKey, MemoVariants, MemoKeyHash> entries;  ///< Looked up, never gone through.
  MemoKey asked;                                                   ///< The key that is being made.
  std::vector<MemoEntry*> seen;                                    ///< Those of kSeen, in the order of their terminals.
  std::vector<OpenNode> open;
  std::vector<BodyRecord> bodies;  ///< By Body::number.
};

/// A node that begins.
struct Recording {
  MemoEntry* entry = nullptr;  ///< Null: the node is not noted.
  bool known = false;          ///< There is a pattern; the node need not be derived.
  Made before;                 ///< Where the tables of the run ended.
};

/// Looks the node up, and notes where it begins if it is the first of its kind.
Recording begin_recording(Execution& execution, const Body& body);
/// Copies what the first of its kind became to this node's shape: within kSame_m of what its own derivation would be,
/// where no rule decides by less.
NodeTrace repeat(Execution& execution, const MemoEntry& entry);
/// Notes what the node made, if it may be a pattern.
void end_recording(Run& run, const Body& body, const Recording& recording, NodeTrace trace);
/// Has to be told before terminals from `first` on are taken away.
void forget_terminals(Memo& memo, std::size_t first);

}  // namespace citykiln::grammars
