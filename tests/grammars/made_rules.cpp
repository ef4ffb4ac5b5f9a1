#include "tests/grammars/made_rules.h"

#include <algorithm>
#include <cmath>

#include "compiler/geometry/box.h"
#include "compiler/geometry/ring_crossing.h"
#include "compiler/geometry/trig.h"
#include "grammars/language/builtin.h"
#include "tests/grammars/made_mass.h"

namespace citykiln::grammars {
namespace {

constexpr int kRules = 6;

std::vector<std::string> words_in(std::string_view text, char between) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == between) {
      words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (between == ' ') std::erase(words, "");
  return words;
}

/// Writes one rule file.
struct RuleWriter {
  Choices& choices;
  int level = 0;      ///< Number of the rule that is being written.
  int nested = 0;     ///< Depth of nested expressions and blocks.
  int arity = 0;      ///< Number of the rule's parameters: x, y.
  bool asks = false;  ///< True if expressions may refer to the shape; those of attributes may not.

  // ---- expressions

  std::string literal() {
    constexpr const char* kOdd[] = {"0", "-1", "1e-9", "1e9", "1e300", "(0/0)", "(1/0)", "0.000001", "90", "45"};
    return choices.one_in(8) ? choices.of(kOdd) : std::to_string(choices.between(-0.5, 4));
  }
  std::string text() {
    constexpr const char* kTexts[] = {"\"\"", "\"#80a0c0\"", "\"brick\"", "\"#zz\"", "s0", "str(a0)"};
    return choices.of(kTexts);
  }
  std::string truth() {
    constexpr const char* kSigns[] = {" < ", " == ", " != ", " >= "};
    constexpr const char* kTruths[] = {"true", "b0", "!b0", "p(0.5)", "has_entrance()", "inside()", "overlaps"};
    return choices.one_in(2) ? choices.of(kTruths) : number() + choices.of(kSigns) + number();
  }
  std::string name() {
    constexpr const char* kLocals[] = {"a0", "a1", "c0", "f0", "rand", "x", "y"};
    const std::string word = kLocals[choices.below(static_cast<std::size_t>(5 + arity))];
    if (!asks || choices.one_in(2)) return word;
    return choices.of(shape_values()).name;
  }
  std::string value_of(char letter) {
    if (letter == 's') return text();
    if (letter == 'b') return truth();
    return letter == 'v' && choices.one_in(3) ? text() : number();
  }
  std::string call() {
    if (choices.one_in(4)) return "f1(" + number() + ", " + number() + ")";
    const BuiltinRow row = choices.of(builtin_functions());
    const Arity arity_of_row = arity_of(row.arguments);
    std::string letters = row.arguments, made;
    std::erase(letters, '/');
    const bool gives_all = choices.one_in(2);
    for (std::size_t i = 0; i < (gives_all ? arity_of_row.most : arity_of_row.least); ++i)
      made += (i ? ", " : "") + value_of(letters[i]);
    return std::string(row.name) + "(" + made + ")";
  }
  std::string number() {
    if (nested > 4) return literal();
    ++nested;
    const std::string made = compound();
    --nested;
    return made;
  }
  std::string compound() {
    constexpr const char* kSigns[] = {" + ", " - ", " * ", " / ", " % "};
    switch (choices.below(12)) {
      case 7:
        return name();
      case 8:
        return call();
      case 9:
        return "(" + number() + choices.of(kSigns) + number() + ")";
      case 10:
        return "(case " + truth() + " : " + number() + " else : " + number() + ")";
      case 11:
        return "(40% : " + number() + " else : " + number() + ")";
      default:
        return literal();
    }
  }

  // ---- bodies

  std::string argument(char letter, const OperationRow& row) {
    if (letter == 'w') return choices.of(words_in(row.words, ' '));
    constexpr const char* kSettable[] = {"a0", "b0", "s0", "material.color.r", "material.name", "material.opacity"};
    if (letter == 'a') return choices.of(kSettable);
    std::string made = letter == 'm' && choices.one_in(3) ? "'" : "";
    return made += letter == 'm' ? number() : value_of(letter);
  }

  std::string successor() {
    if (choices.one_in(8)) return "NIL";
    if (level + 1 >= kRules || choices.one_in(5)) return "End.";
    // recursion, which limits have to end
    const int to = choices.one_in(16) ? static_cast<int>(choices.below(kRules))
                                      : level + 1 + static_cast<int>(choices.below(std::size_t(kRules - level - 1)));
    if (to == 0) return "Lot";
    return "R" + std::to_string(to) + (to % 3 == 2 ? "(" + number() + ", " + number() + ")" : "");
  }

  std::string piece() { return nested < 3 && choices.one_in(4) ? body() : successor(); }

  std::string sizes() {
    constexpr const char* kSigns[] = {"", "'", "~"};
    std::string made;
    for (std::uint32_t i = 0, n = 1 + choices.below(3); i < n; ++i)
      made += (i ? " | " : "") + std::string(choices.of(kSigns)) + number() + " : " + piece();
    if (choices.one_in(2)) made += " | { ~" + number() + " : " + successor() + " }*";
    return " { " + made + " }" + (choices.one_in(6) ? "*" : "");
  }

  std::string parts(std::string_view operation) {
    constexpr const char* kOfFaces[] = {"front",  "top",    "side",        "all",    "street",   "bottom",
                                        "back",   "left",   "right",       "aslant", "vertical", "horizontal",
                                        "border", "inside", "street.back", "2"};
    constexpr const char* kOfBands[] = {"all", "remainder", "front", "street.front", "left", "back", "1"};
    constexpr const char* kOfStrips[] = {"shape", "remainder"};
    std::string made;
    for (std::uint32_t i = 0, n = 1 + choices.below(3); i < n; ++i) {
      const std::string key = operation == "comp"                               ? choices.of(kOfFaces)
                              : operation == "setback" || operation == "offset" ? choices.of(kOfBands)
                                                                                : choices.of(kOfStrips);
      made += (i ? " | " : "") + key + (choices.one_in(4) ? " = " : " : ") + piece();
    }
    return " { " + made + " }";
  }

  std::string operation() { return operation_of_row(choices.of(operation_table())); }
  // an operation with selectors, as in rules of houses
  std::string division() {
    std::vector<OperationRow> rows;
    for (const OperationRow& row : operation_table())
      if (row.selectors != SelectorKind::kNone) rows.push_back(row);
    return operation_of_row(choices.of(rows));
  }
  // Sides that follow the tolerance would change what is counted; solids_test.cpp tests those.
  std::string round_primitive(const OperationRow& row) {
    constexpr const char* kAxesAndSides[] = {"x, 3", "y, 4", "z, 5", "6", "x, 8"};
    return std::string(row.name) + "(" + choices.of(kAxesAndSides) + ") ";
  }
  std::string operation_of_row(const OperationRow& row) {
    if (is_among(row.name, " primitiveCylinder primitiveCone primitiveSphere primitiveDome "))
      return round_primitive(row);
    std::string made, signature = choices.of(words_in(row.signatures, '|'));
    for (const char letter : signature) made += (made.empty() ? "" : ", ") + argument(letter, row);
    made = std::string(row.name) + "(" + made + ")";
    if (row.selectors == SelectorKind::kSizes) made += sizes();
    if (row.selectors == SelectorKind::kParts) made += parts(row.name);
    if (row.selectors == SelectorKind::kBody) made += " { " + piece() + " }";
    return made + " ";
  }

  std::string statements() {
    std::string made;
    for (std::uint32_t i = 0, n = 1 + choices.below(3); i < n; ++i) {
      if (choices.one_in(5)) made += "[ " + operation() + successor() + " ] ";
      made += operation();
    }
    if (choices.one_in(2)) return made + division();
    return choices.one_in(2) ? made + successor() : made;
  }

  std::string body() {
    ++nested;
    std::string made = statements();
    const std::uint32_t kind = choices.below(6);
    if (kind == 4) made = "case " + truth() + " : " + made + " else : " + statements();
    if (kind == 5) made = "30% : " + made + " else : " + successor();
    --nested;
    return made;
  }

  std::string rule(int which) {
    level = which, arity = which % 3 == 2 ? 2 : 0;
    const std::string head = "R" + std::to_string(which) + (arity ? "(x, y)" : "");
    if (which == 0) return "Lot --> extrude(" + std::to_string(choices.between(2, 9)) + ") " + statements() + "\n";
    if (choices.one_in(8)) return head + " --> with( w := " + number() + " ) " + operation() + "t(w, 0, w) End.\n";
    return head + " --> " + body() + "\n";
  }
};

double metres_at(Choices& choices, double most) { return std::round(choices.between(0, most) * 8) / 8; }

Ring star(Choices& choices, double radius_m, bool turns_on) {
  Ring ring;
  const std::uint32_t corners = 3 + choices.below(14);
  for (std::uint32_t i = 0; i < corners; ++i) {
    const double turn = turns_on ? (i + choices.between(0, 0.9)) / corners : choices.between(0, 1);
    ring.push_back(direction_of(turn) * (radius_m * choices.between(0.2, 1)));
  }
  return ring;
}

Ring steps(Choices& choices) {
  Ring ring;
  double x = 0;
  for (std::uint32_t i = 0, n = 2 + choices.below(5); i < n; ++i) {
    const double top = 2 + metres_at(choices, 12);
    ring.push_back({x, top});
    ring.push_back({x += 1 + metres_at(choices, 6), top});
  }
  ring.push_back({x, 0});
  ring.push_back({0, 0});
  std::reverse(ring.begin(), ring.end());
  return ring;
}

// Invalid outlines, which maps contain.
void spoil(Choices& choices, Polygon& footprint) {
  Ring& ring = footprint.outer;
  switch (choices.below(6)) {
    case 0:
      return void(std::reverse(ring.begin(), ring.end()));
    case 1:
      return void(ring = star(choices, 9, false));
    case 2:
      return void(ring.push_back(ring.front()));
    case 3:
      return void(ring.resize(choices.below(3)));
    case 4:
      for (Vec2& p : ring) p.y *= 1e-3;
      return;
    default:
      for (Vec2& p : ring) p = p * 1e4;
  }
}

}  // namespace

std::string made_rules(Choices& choices) {
  RuleWriter writer{choices};
  std::string made = "attr a0 = " + writer.literal() + "\nattr b0 = " + (choices.one_in(2) ? "true" : "false");
  made += "\nattr s0 = \"stone\"\nattr a1 = 50% : " + writer.literal() + " else : " + writer.literal();
  made += "\nconst c0 = " + writer.literal() + "\nf0 = a0 + c0\n";
  writer.asks = true;
  writer.arity = 2;
  made += "f1(x, y) = " + writer.number() + "\n";
  for (int i = 0; i < kRules; ++i) made += writer.rule(i);
  return made;
}

Polygon made_footprint(Choices& choices) {
  const double width_m = 3 + metres_at(choices, 20), depth_m = 3 + metres_at(choices, 15);
  Polygon footprint{{{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}}, {}};
  const std::uint32_t kind = choices.below(4);
  if (kind == 1) footprint.outer = steps(choices);
  if (kind == 2) footprint.outer = star(choices, 12, true);
  if (kind == 3) footprint.holes = {{{1, 1}, {1, depth_m - 1}, {width_m - 1, depth_m - 1}, {width_m - 1, 1}}};
  if (choices.one_in(6)) spoil(choices, footprint);
  return footprint;
}

bool is_sound(const Polygon& footprint) {
  Box2 box;
  for (const Vec2 p : footprint.outer) box.grow(p);
  const auto is_within = [&](const Ring& hole) {
    return !borders_touch(footprint.outer, hole) && winding_number(footprint.outer, hole.front()) != 0;
  };
  const bool are_within = std::all_of(footprint.holes.begin(), footprint.holes.end(), is_within);
  return std::max(box.width(), box.height()) < 100 && is_simple(footprint.outer) && are_within &&
         signed_area_m2(footprint.outer) > 0;
}

Shape made_shape(Choices& choices, const Polygon& footprint) {
  MadeMass made;
  made.footprint = footprint;
  made.height_m = 2 + metres_at(choices, 12);
  if (!is_sound(footprint) || choices.one_in(2))
    return lot(footprint, 2, choices.below(4), StableId{choices.byte()}, {choices.below(4)});
  made.roof.form = static_cast<roofs::RoofForm>(choices.below(static_cast<std::size_t>(roofs::RoofForm::kCount)));
  made.roof.overhang_m = choices.one_in(2) ? 0.5 : 0;
  made.party = {choices.below(4)};
  return mass_model_of(made);
}

}  // namespace citykiln::grammars
