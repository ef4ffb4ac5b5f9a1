#include "lsystems/read_lsystem.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>

#include "lsystems/reader.h"

namespace citykiln::lsystems {
namespace {

struct Statement {
  std::size_t begin = 0, end = 0;
  bool has_arrow = false;
};

enum class Section { kProductions, kDecomposition, kInterpretation, kEnd };

// what the statements say before all of them are read
struct FileState {
  Section section = Section::kProductions;
  std::set<std::string> ignored;
  bool only_considered = false;  // `ignored` names what is considered
  bool has_axiom = false;
};

using ReadDirective = void (*)(Reader&, FileState&);

struct Directive {
  std::string_view name;
  ReadDirective read;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// ---- from text to statements ----

// /* … */ become spaces, so that places stay what they were
std::optional<std::size_t> blank_comments(std::string& text) {
  for (std::size_t from = text.find("/*"); from != std::string::npos; from = text.find("/*", from)) {
    const std::size_t to = text.find("*/", from + 2);
    if (to == std::string::npos) return from;
    for (; from < to + 2; ++from)
      if (text[from] != '\n') text[from] = ' ';
  }
  return std::nullopt;
}

std::string_view without_space(std::string_view line) {
  while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
  return line;
}

bool begins_directive(std::string_view line);

// a line that begins with space goes on with the statement before it, unless it is one of its own
bool goes_on(std::string_view line, bool has_arrow) {
  return is_space(line[0]) && !has_arrow && !begins_directive(line);
}

std::vector<Statement> statements_of(std::string_view text) {
  std::vector<Statement> statements;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    const bool is_comment = line.starts_with("//");
    const bool has_arrow = line.find("->") != std::string_view::npos;
    if (!without_space(line).empty() && !is_comment) {
      if (!statements.empty() && goes_on(line, has_arrow))
        statements.back().end = end;
      else
        statements.push_back({begin, end, has_arrow});
    }
    begin = end + 1;
  }
  return statements;
}

std::vector<std::size_t> line_starts_of(std::string_view text) {
  std::vector<std::size_t> starts{0};
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') starts.push_back(i + 1);
  return starts;
}

// ---- directives ----

double read_number_of(Reader& reader, std::string_view what, double least, double most) {
  reader.skip_space();
  const TextPosition place = reader.place();
  const double number = read_constant(reader, what);
  if (!reader.failed && !(number >= least && number <= most))
    reader.fail(place, fmt::format("expected {}, {} to {}, found {}", what, least, most, number));
  return reader.failed ? least : number;
}

constexpr std::size_t kLongNames = 1000;
constexpr double kLargest = 1e9;  // of lengths and angles: beyond that a plant's metres have lost their digits

void read_steps(Reader& reader, FileState&) {
  reader.system.steps = static_cast<int>(read_number_of(reader, "the number of steps", 0, 1e9));
}
void read_angle(Reader& reader, FileState&) {
  reader.system.angle_deg = read_number_of(reader, "an angle in degrees", -kLargest, kLargest);
}
void read_step(Reader& reader, FileState&) {
  reader.system.step = read_number_of(reader, "a length", -kLargest, kLargest);
}
void read_width(Reader& reader, FileState&) { reader.system.width = read_number_of(reader, "a width", 0, kLargest); }
void read_width_unit(Reader& reader, FileState&) {
  reader.system.width_unit = read_number_of(reader, "a length", 0, kLargest);
}
void read_height(Reader& reader, FileState&) { reader.system.height = read_number_of(reader, "a height", 0, kLargest); }
void read_seed(Reader& reader, FileState&) {
  reader.system.seed = static_cast<std::uint64_t>(read_number_of(reader, "a seed", 0, 1e15));
}
void read_bark(Reader& reader, FileState&) {
  reader.system.bark = take_name(reader);
  if (reader.system.bark.empty()) reader.fail_expected("the bark's name");
}
void read_elasticity(Reader& reader, FileState&) {
  reader.system.elasticity = read_number_of(reader, "an elasticity", -1e3, 1e3);
}

void read_tropism(Reader& reader, FileState&) {
  const auto part = [&] { return read_number_of(reader, "a part of a direction", -kLargest, kLargest); };
  reader.system.tropism.x = part();
  reader.expect(",", "between the parts x, y and z of the tropism");
  reader.system.tropism.y = part();
  reader.expect(",", "between the parts x, y and z of the tropism");
  reader.system.tropism.z = part();
}

void read_axiom(Reader& reader, FileState& state) {
  reader.skip_space();
  if (state.has_axiom) return reader.fail(reader.place(), "the axiom is given twice");
  state.has_axiom = true;
  reader.system.axiom_place = reader.place();
  reader.may_draw = true;
  reader.dice = 0;
  reader.system.axiom = read_successor(reader);
  reader.may_draw = false;
  // the axiom's dice are a module's at place 0
  if (reader.dice > 16) reader.fail(reader.system.axiom_place, "an axiom throws at most 16 dice");
}

void read_define(Reader& reader, FileState&) {
  const TextPosition place = reader.place();
  const std::string name = take_name(reader);
  if (name.empty()) return reader.fail_expected("the constant's name");
  const double value = read_constant(reader, "the constant's value");
  const auto given = reader.given.find(name);
  const bool is_new = reader.constants.emplace(name, given == reader.given.end() ? value : given->second).second;
  if (!is_new) reader.fail(place, fmt::format("the constant '{}' is defined twice", name));
}

void read_ignored(Reader& reader, FileState& state) {
  for (std::string name = take_module_name(reader); !name.empty(); name = take_module_name(reader)) {
    if (name == "[" || name == "]")
      return reader.fail(reader.place(), "contexts follow brackets: they cannot be ignored");
    state.ignored.insert(name);
  }
}

void read_considered(Reader& reader, FileState& state) {
  state.only_considered = true;
  read_ignored(reader, state);
}

// module plant, seg
void read_module(Reader& reader, FileState&) {
  do {
    const std::string name = take_name(reader);
    if (name.empty()) return reader.fail_expected("a module's name");
    if (reader.long_names.size() == kLongNames)
      return reader.fail(reader.place(), fmt::format("a file declares at most {} names", kLongNames));
    reader.long_names.push_back(name);
  } while (reader.accept(","));
  std::stable_sort(reader.long_names.begin(), reader.long_names.end(),
                   [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
}

void read_depth(Reader& reader, FileState& state) {
  const auto depth = static_cast<int>(read_number_of(reader, "a depth", 1, kDepthLimit));
  if (state.section == Section::kDecomposition) reader.system.decomposition.most_depth = depth;
  if (state.section == Section::kInterpretation) reader.system.interpretation.most_depth = depth;
}

template <Section kSection>
void begin_section(Reader&, FileState& state) {
  state.section = kSection;
}

void read_cpfg_start(Reader& reader, FileState&) { read_number_of(reader, "the system's number", 0, 1e9); }

constexpr Directive kDirectives[] = {
    {"#define", read_define},
    {"#ignore", read_ignored},
    {"#consider", read_considered},
    {"Lsystem", read_cpfg_start},
    {"module", read_module},
    {"ignore", read_ignored},
    {"consider", read_considered},
    {"axiom", read_axiom},
    {"omega", read_axiom},
    {"\u03c9", read_axiom},
    {"n", read_steps},
    {"derivation length", read_steps},
    {"delta", read_angle},
    {"\u03b4", read_angle},
    {"angle", read_angle},
    {"step", read_step},
    {"width unit", read_width_unit},
    {"width", read_width},
    {"height", read_height},
    {"bark", read_bark},
    {"seed", read_seed},
    {"tropism", read_tropism},
    {"elasticity", read_elasticity},
    {"maximum depth", read_depth},
    {"production", begin_section<Section::kProductions>},
    {"decomposition", begin_section<Section::kDecomposition>},
    {"homomorphism", begin_section<Section::kInterpretation>},
    {"interpretation", begin_section<Section::kInterpretation>},
    {"endlsystem", begin_section<Section::kEnd>},
};

// the directive whose name stands at the line's beginning, as a word of its own
const Directive* directive_of(std::string_view line) {
  for (const Directive& directive : kDirectives) {
    if (!line.starts_with(directive.name)) continue;
    const char next = line.size() > directive.name.size() ? line[directive.name.size()] : ' ';
    if (!is_name_letter(next) && next != '(') return &directive;
  }
  return nullptr;
}

bool begins_directive(std::string_view line) {
  line = without_space(line);
  const Directive* directive = directive_of(line);
  if (directive == nullptr) return false;
  // a single letter may be a module that a production's successor goes on with
  const std::string_view rest = without_space(line.substr(directive->name.size()));
  return line[0] == '#' || rest.empty() || rest[0] == ':' || rest[0] == '=' || directive->name == "module";
}

bool has_modules(const Directive& directive) {
  return directive.read == read_axiom || directive.read == read_ignored || directive.read == read_considered;
}

void read_directive(Reader& reader, FileState& state) {
  reader.skip_space();
  const std::string_view line = reader.text.substr(reader.at, reader.end - reader.at);
  const Directive* directive = directive_of(line);
  if (directive == nullptr) return reader.fail_expected("a production with '->', or a directive");
  // where // rolls no turtle it begins a comment
  if (!has_modules(*directive)) reader.end = reader.at + std::min(line.find("//"), line.size());
  reader.at += directive->name.size();
  if (!reader.accept(":")) reader.accept("=");
  directive->read(reader, state);
  reader.skip_space();
  if (!reader.failed && !reader.done()) reader.fail_expected("the end of the line");
}

// ---- all together ----

RuleSet& set_of(LSystem& system, Section section) {
  if (section == Section::kDecomposition) return system.decomposition;
  return section == Section::kInterpretation ? system.interpretation : system.productions;
}

void read_statement(Reader& reader, FileState& state, const Statement& statement) {
  reader.at = statement.begin;
  reader.end = statement.end;
  if (!statement.has_arrow) return read_directive(reader, state);
  reader.may_query = state.section != Section::kInterpretation;
  read_rule(reader, set_of(reader.system, state.section), state.section == Section::kProductions);
  reader.may_query = true;
}

void sort_rules(RuleSet& set, std::size_t kinds) {
  std::stable_sort(set.rules.begin(), set.rules.end(),
                   [](const Rule& a, const Rule& b) { return a.predecessor < b.predecessor; });
  set.of_kind.assign(kinds, {});
  for (std::uint32_t i = 0; i < set.rules.size(); ++i) {
    Range& range = set.of_kind[set.rules[i].predecessor];
    if (range.count++ == 0) range.first = i;
  }
}

void note_ignored(LSystem& system, const FileState& state) {
  for (ModuleKind& kind : system.kinds) kind.ignored = state.ignored.contains(kind.name) != state.only_considered;
}

// a context of what contexts look past would never fit
void refuse_ignored_contexts(Reader& reader) {
  const LSystem& system = reader.system;
  for (const Rule& rule : system.productions.rules)
    for (const Range range : {rule.left, rule.right})
      for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
        const ModuleKind& kind = system.kinds[system.contexts[i]];
        const bool bracket = kind.op == TurtleOp::kPush || kind.op == TurtleOp::kPop;
        if (kind.ignored && !bracket)
          reader.fail(rule.place, fmt::format("'{}' is ignored: it cannot be a context", kind.name));
      }
}

bool writes_cuts(const LSystem& system) {
  return std::find(system.successor_kinds.begin(), system.successor_kinds.end(), system.cut) !=
         system.successor_kinds.end();
}

void finish(Reader& reader, const FileState& state) {
  LSystem& system = reader.system;
  note_ignored(system, state);
  refuse_ignored_contexts(reader);
  system.has_cuts = writes_cuts(system);
  for (RuleSet* set : {&system.productions, &system.decomposition, &system.interpretation})
    sort_rules(*set, system.kinds.size());
}

}  // namespace

Result<LSystem> read_lsystem(std::string_view text, std::string_view file,
                             const std::map<std::string, double, std::less<>>& given) {
  const std::string name(file);
  if (text.size() > kTextLimit)
    return Error{name, fmt::format("expected at most {} bytes, found {}", kTextLimit, text.size())};
  std::string blanked(text);
  const auto open_comment = blank_comments(blanked);
  Reader reader;
  reader.text = blanked;
  reader.file = name;
  reader.line_starts = line_starts_of(blanked);
  reader.given = given;
  reader.system.file = name;
  if (open_comment)
    return Error{position_name(name, reader.position_at(*open_comment)),
                 "expected */ that ends the comment, found the end of the file"};
  reader.system.push = kind_named(reader, "[", 0);
  reader.system.pop = kind_named(reader, "]", 0);
  reader.system.cut = kind_named(reader, "%", 0);
  FileState state;
  for (const Statement& statement : statements_of(blanked)) {
    if (state.section == Section::kEnd || reader.failed) break;
    read_statement(reader, state, statement);
  }
  if (reader.failed) return *reader.failed;
  if (!state.has_axiom) return Error{name, "expected an axiom, found the end of the file"};
  finish(reader, state);
  if (reader.failed) return *reader.failed;
  return std::move(reader.system);
}

}  // namespace citykiln::lsystems
