#include "grammars/roofs/roof_shape.h"

#include <array>
#include <cassert>
#include <string>

namespace citykiln::roofs {
namespace {

constexpr std::array<FormRow, static_cast<std::size_t>(RoofForm::kCount)> kForms = {{
#define ROOF_FORM(enumerator, tag, pitch_deg, method, end, has_eaves) {tag, pitch_deg, method, end, has_eaves},
#include "grammars/roofs/roof_forms.inc"
#undef ROOF_FORM
}};

struct RoofName {
  std::string_view name;
  RoofForm form;
};
constexpr RoofName kNames[] = {
#define ROOF_NAME(name, form) {name, RoofForm::form},
#include "grammars/roofs/roof_names.inc"
#undef ROOF_NAME
};

// "Lean-to roof" becomes "lean_to".
std::string plain_roof_name(std::string_view name) {
  std::string plain;
  for (const char c : name)
    plain += c == ' ' || c == '-' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (plain.ends_with("_roof")) plain.resize(plain.size() - std::string_view("_roof").size());
  return plain;
}

}  // namespace

const FormRow& form_row(RoofForm form) {
  assert(form < RoofForm::kCount);
  return kForms[static_cast<std::size_t>(form)];
}

std::string_view name_of(RoofForm form) { return form_row(form).name; }

std::optional<RoofForm> form_named(std::string_view name) {
  const std::string plain = plain_roof_name(name);
  for (std::size_t i = 0; i < kForms.size(); ++i)
    if (plain_roof_name(kForms[i].name) == plain) return static_cast<RoofForm>(i);
  for (const RoofName& row : kNames)
    if (row.name == plain) return row.form;
  return std::nullopt;
}

}  // namespace citykiln::roofs
