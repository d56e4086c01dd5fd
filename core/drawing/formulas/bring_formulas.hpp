#pragma once

#include "core/drawing/document/document.hpp"
#include "core/engine/spacing/parts/expression/expression_program.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// Old names of parameters and their new ones.
using NameChanges = std::map<std::string, std::string, std::less<>>;

/// Returns the formula of a number in a drawing that is scaled by a factor; `power`: see lengthPower().
std::string timesLength(const std::string &formula, double scale, int power);

/// Returns an expression with names replaced, all at once.
std::string renameIn(const std::string &text, const NameChanges &names);

/// Returns parameters that have these values and depend on nothing.
std::vector<Parameter> constantParameters(const NamedValues &values);

/// Adds the named parameters of a list, and those that they depend on, to a document. A parameter that the document
/// already has with the same value is shared. If its value differs, the new one gets a free name, such as r_2;
/// `changes` is set to these names. If the document would have more than kMaxParameters, adds nothing and returns
/// false.
bool bringParameters(Document &document, const std::vector<Parameter> &from, const std::set<std::string> &wanted,
                     NameChanges &changes);

/// The items that a document has received from another document: maps from old to new ids and indices.
struct ReceivedItems {
    std::map<std::uint32_t, std::uint32_t> shapes{}, sources{}, markers{}, constraints{};
};

/// Adds the formulas of received items to a document, with the parameters that they use. `scale` is the factor by which
/// the items were scaled. A number that differs from the value of its formula stays a plain number. If the document
/// would have more than kMaxParameters parameters, no formula is added; returns how many were left out.
std::size_t bringFormulas(Document &document, const Document &from, const ReceivedItems &items, double scale = 1.0);

} // namespace forefront
