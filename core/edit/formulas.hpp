#pragma once

#include "core/base/result.hpp"
#include "core/edit/document.hpp"
#include "core/spacing/parts/expression/expression_program.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace forefront {

// Parameters, and numbers of a document that follow them.
//
// Document::formulas holds expressions by the address of their number; see number_address.hpp. A formula holds as long
// as its number has its value: a number that is changed by hand loses its formula.

/// A document has at most this many parameters.
inline constexpr std::size_t kMaxParameters = 1000;
/// The name of a parameter has at most this many characters.
inline constexpr std::size_t kMaxParameterName = 100;

/// The value of a parameter, or why it has none.
struct ParameterState {
    std::optional<double> value;
    std::string fault;       ///< empty if there is a value
    bool faultyName = false; ///< the fault is that of the name, not of the expression
};

/// Returns the state of each parameter, in order. Faults: a name that is empty, reserved, too long or given twice, an
/// expression that is wrong, a cycle, too many parameters.
std::vector<ParameterState> parameterStates(const std::vector<Parameter> &parameters);

/// Returns the values of the parameters that have one.
NamedValues parameterValues(const std::vector<Parameter> &parameters);

/// Returns the value of an expression of the parameters of a document. Errors: expression-syntax, expression-value.
Result<double> evaluateFormula(const Document &document, const std::string &text);

/// Sets every number that has a formula to the formula's value. Errors: those of evaluateFormula() and of the commands
/// that set the numbers, bad-formula if there is no such number or formulas contradict each other; `failed`, if not
/// null, becomes the address.
Result<Document> applyFormulas(const Document &document, std::string *failed = nullptr);

/// Replaces the parameters and moves every number with a formula to its new value. Errors: bad-parameter (a fault of
/// parameterStates()), and those of applyFormulas().
Result<Document> setParameters(const Document &document, std::vector<Parameter> parameters);

/// Gives parameters other expressions, by name. Errors: unknown-parameter, and those of setParameters().
Result<Document> overrideParameters(const Document &document, const std::map<std::string, std::string> &expressions);

/// Renames a parameter, also in the expressions and formulas that use it. Errors: bad-parameter.
Result<Document> renameParameter(const Document &document, std::size_t index, const std::string &name);

/// Lets a number follow a formula, or stand alone if the text is empty or a plain number; the number itself stays as it
/// is.
Document setFormula(Document document, const std::string &address, const std::string &text);

/// Removes the formulas whose numbers are gone or have another value.
void pruneFormulas(Document &document);

/// Prepares the formulas of a document that came from another by a command: those of nodes, sources and markers whose
/// indices have changed move with them, and those that no longer hold are removed.
void carryFormulas(const Document &before, Document &next);

/// Gives a copy of a shape, source or marker the formulas of the original, such as from "shape/3/" to "shape/7/".
void copyFormulas(Document &document, std::string_view fromPrefix, std::string_view toPrefix);

} // namespace forefront
