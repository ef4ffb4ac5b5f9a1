// What was mended, approximated or dropped, by name, with the OSM id and a size; and the ledger in which in = out +
// dropped balances.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/contract/stable_id.h"

namespace citykiln {

enum class Severity : std::uint8_t { kNote, kMended, kDropped };

enum class Code : std::uint8_t {
#define CODE(name, severity, text) name,
#include "compiler/contract/diagnosis_codes.inc"
#undef CODE
};

std::string_view name_of(Code code);  ///< "MissingNode".
std::string_view text_of(Code code);  ///< What happened, a clause without full stop.
Severity severity_of(Code code);
std::string_view name_of(Severity severity);  ///< "note", "mended", "dropped".

struct Diagnosis {
  Code code;
  OsmId object;
  double size =
      0;  ///< How much: metres, square metres, samples, as the code's text says. 0 where there is nothing to measure.
};

/// One line of the ledger: what became of the objects of one kind in one stage. Balances when in + split = out + merged
/// + dropped.
struct Account {
  std::uint64_t in = 0;
  std::uint64_t split = 0;  ///< Objects gained because one became several.
  std::uint64_t out = 0;
  std::uint64_t merged = 0;  ///< Objects that went into another (a building's outline into its parts).
  std::map<Code, std::uint64_t> dropped;

  bool balances() const;
};

/// The diagnoses and the ledger of a run. A value: parallel work fills one Report a slot, and they are appended in
/// order.
class Report {
 public:
  void add(Code code, OsmId object, double size = 0) { diagnoses_.push_back({code, object, size}); }

  /// Adds the diagnosis and counts the object as dropped from `account`.
  void drop(Account& account, Code code, OsmId object, double size = 0);

  /// The account of a feature kind ("building") in a stage ("map"). The reference lives as long as the report.
  Account& account(std::string_view stage, std::string_view kind);

  void append(const Report& other);

  const std::vector<Diagnosis>& diagnoses() const { return diagnoses_; }
  /// Keyed by "stage/kind".
  const std::map<std::string, Account, std::less<>>& ledger() const { return ledger_; }
  std::map<Code, std::uint64_t> counts() const;
  bool balances() const;

 private:
  std::vector<Diagnosis> diagnoses_;
  std::map<std::string, Account, std::less<>> ledger_;
};

}  // namespace citykiln
