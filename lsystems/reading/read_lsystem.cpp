#include "lsystems/reading/read_lsystem.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <set>
#include <type_traits>

#include "lsystems/reading/reader.h"

namespace citykiln::lsystems {
namespace {

struct Statement {
  std::size_t begin = 0, end = 0;
  bool has_arrow = false;
};

enum class Section { kProductions, kDecomposition, kInterpretation, kEnd };

// Values that directives set for the whole file.
struct FileState {
  Section section = Section::kProductions;
  std::set<std::string> ignored;
  bool only_considered = false;  // `ignored` lists the considered modules
  bool has_axiom = false;
};

using ReadDirective = void (*)(Reader&, FileState&);

struct Directive {
  std::string_view name;
  ReadDirective read;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

// Replaces comments by spaces, which keeps positions. Returns where a comment without end begins.
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

// A line that begins with space continues the previous statement, unless it has an arrow or is a directive.
bool continues_statement(std::string_view line, bool has_arrow) {
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
      if (!statements.empty() && continues_statement(line, has_arrow))
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

double read_number_of(Reader& reader, std::string_view what, double least, double most) {
  reader.skip_space();
  const TextPosition place = reader.place();
  const double number = read_constant(reader, what);
  if (!reader.failed && !(number >= least && number <= most))
    reader.fail(place, fmt::format("expected {}, {} to {}, found {}", what, least, most, number));
  return reader.failed ? least : number;
}

constexpr std::size_t kLongNames = 1000;
constexpr double kLargest = 1e9;  // limit of lengths and angles, at which doubles still resolve micrometres

struct NumberRange {
  std::string_view what;
  double least, most;
};
constexpr NumberRange kSteps{"the number of steps", 0, 1e9}, kAngle{"an angle in degrees", -kLargest, kLargest},
    kStep{"a length", -kLargest, kLargest}, kWidth{"a width", 0, kLargest}, kWidthUnit{"a length", 0, kLargest},
    kHeight{"a height", 0, kLargest}, kSeed{"a seed", 0, 1e15}, kElasticity{"an elasticity", -1e3, 1e3};

template <auto kMember, const NumberRange& kRange>
void read_member(Reader& reader, FileState&) {
  auto& member = reader.system.*kMember;
  member = static_cast<std::remove_reference_t<decltype(member)>>(
      read_number_of(reader, kRange.what, kRange.least, kRange.most));
}

void read_bark(Reader& reader, FileState&) {
  reader.system.bark = take_name(reader);
  if (reader.system.bark.empty()) reader.fail_expected("the bark's name");
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
  reader.draws = 0;
  reader.system.axiom = read_successor(reader);
  reader.may_draw = false;
  // the axiom's draws are those of position 0
  if (reader.draws > 16) reader.fail(reader.system.axiom_place, "an axiom has at most 16 random draws");
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
    {"n", read_member<&LSystem::steps, kSteps>},
    {"derivation length", read_member<&LSystem::steps, kSteps>},
    {"delta", read_member<&LSystem::angle_deg, kAngle>},
    {"\u03b4", read_member<&LSystem::angle_deg, kAngle>},
    {"angle", read_member<&LSystem::angle_deg, kAngle>},
    {"step", read_member<&LSystem::step, kStep>},
    {"width unit", read_member<&LSystem::width_unit, kWidthUnit>},
    {"width", read_member<&LSystem::width, kWidth>},
    {"height", read_member<&LSystem::height, kHeight>},
    {"bark", read_bark},
    {"seed", read_member<&LSystem::seed, kSeed>},
    {"tropism", read_tropism},
    {"elasticity", read_member<&LSystem::elasticity, kElasticity>},
    {"maximum depth", read_depth},
    {"production", begin_section<Section::kProductions>},
    {"decomposition", begin_section<Section::kDecomposition>},
    {"homomorphism", begin_section<Section::kInterpretation>},
    {"interpretation", begin_section<Section::kInterpretation>},
    {"endlsystem", begin_section<Section::kEnd>},
};

// The directive whose name is the line's first word, or null.
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
  // a single letter may be a module of a continued successor
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
  const bool has_unicode_arrow = line.find("\xe2\x86\x92") != std::string_view::npos;
  if (directive == nullptr)
    return reader.fail_expected(has_unicode_arrow ? "a production with '->' instead of '\xe2\x86\x92'"
                                                  : "a production with '->', or a directive");
  // // begins a comment except among modules, where it rolls twice
  if (!has_modules(*directive)) reader.end = reader.at + std::min(line.find("//"), line.size());
  reader.at += directive->name.size();
  if (!reader.accept(":")) reader.accept("=");
  directive->read(reader, state);
  reader.skip_space();
  if (!reader.failed && !reader.done()) reader.fail_expected("the end of the line");
}

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

// A context of ignored modules would never match.
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

void finish(Reader& reader, const FileState& state) {
  LSystem& system = reader.system;
  note_ignored(system, state);
  refuse_ignored_contexts(reader);
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
