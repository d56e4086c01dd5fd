#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/base/result.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

// Parameters, and the numbers of a document that depend on them.
//
// Document::formulas holds expressions by the address of their number; see NumberAddress. A formula holds as long
// as the number equals its value; a number that is edited directly loses its formula. Shapes, sources and markers that
// are moved as a whole take the formulas of their coordinates along: see shift_formulas.hpp.

/// Maximum number of parameters in a document.
inline constexpr std::size_t kMaxParameters = 1000;
/// Maximum length of a parameter's name, in characters.
inline constexpr std::size_t kMaxParameterName = 100;

/// The value of a parameter, or why it has none.
struct ParameterState {
    std::optional<double> value;
    std::string fault;       ///< empty if there is a value
    bool faultyName = false; ///< the fault lies in the name, not in the expression
    bool follows = false;    ///< the only fault is in a parameter that the expression uses
};

/// Returns the state of each parameter, in order. Faults: an empty, reserved, overlong or duplicate name, an invalid
/// expression, a cycle, too many parameters.
std::vector<ParameterState> parameterStates(const std::vector<Parameter> &parameters);

/// Returns the index of the parameter with a name; the number of parameters if there is none.
std::size_t parameterIndex(const std::vector<Parameter> &parameters, std::string_view name);

/// Returns the first name that is not taken of `stem` with the number `first`, the next one, and so on: p1, p2. Long
/// stems are shortened to keep within kMaxParameterName.
std::string freeParameterName(const std::string &stem, std::size_t first, const std::set<std::string> &taken);

/// Returns the names of parameters.
std::set<std::string> namesOf(const std::vector<Parameter> &parameters);

/// Returns the values of the parameters without faults.
NamedValues parameterValues(const std::vector<Parameter> &parameters);

/// Returns the value of an expression that may use the parameters of a document. Errors: expression-syntax,
/// expression-value.
Result<double> evaluateFormula(const Document &document, const std::string &text);

/// Sets every number that has a formula to the formula's value, and moves what its constraints move: see settle().
/// Errors: those of evaluateFormula(), of settle() and of the commands
/// that set the numbers; bad-formula if there is no such number or formulas contradict each other. On an error
/// `failed`, if not null, is set to the address.
Result<Document> applyFormulas(const Document &document, NumberAddress *failed = nullptr);

/// Replaces the parameters and updates every number with a formula. Errors: bad-parameter (a fault of
/// parameterStates()), and those of applyFormulas().
Result<Document> setParameters(const Document &document, std::vector<Parameter> parameters);

/// Replaces the expressions of some parameters, by name. Errors: unknown-parameter, and those of setParameters().
Result<Document> overrideParameters(const Document &document, const std::map<std::string, std::string> &expressions);

/// Removes a parameter that nothing uses. Errors: bad-parameter if there is none; parameter-in-use names what uses it.
Result<Document> removeParameter(const Document &document, std::size_t index);

/// Renames a parameter, including in the expressions and formulas that use it. Errors: bad-parameter.
Result<Document> renameParameter(const Document &document, std::size_t index, const std::string &name);

/// Sets the formula of a number; an empty text or a plain number removes it. The number itself is unchanged.
Document setFormula(Document document, const NumberAddress &address, const std::string &text);

/// Removes the formulas whose numbers no longer exist or have a different value.
void pruneFormulas(Document &document);

/// Updates the formulas of a document after a command changed it: formulas follow nodes, sources and markers whose
/// indices have changed, and those that no longer hold are removed.
void carryFormulas(const Document &before, Document &next);

/// Consecutive formulas of a document; valid until the formulas change.
struct FormulaRange {
    std::map<NumberAddress, std::string>::iterator first, last;

    auto begin() const { return first; }
    auto end() const { return last; }
};

/// Returns the formulas of the numbers of an item, in order.
FormulaRange formulasOf(Document &document, NumberOwner owner);

/// Copies the formulas of a shape, source or marker to its copy.
void copyFormulas(Document &document, NumberOwner from, NumberOwner to);

} // namespace forefront
