#pragma once

#include "core/edit/document.hpp"
#include "core/spacing/parts/expression/expression_program.hpp"

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace forefront {

/// Old names of parameters and their new ones.
using NameChanges = std::map<std::string, std::string, std::less<>>;

/// Returns an expression with names replaced, all at once.
std::string renameIn(const std::string &text, const NameChanges &names);

/// Returns parameters that have these values and depend on nothing.
std::vector<Parameter> constantParameters(const NamedValues &values);

/// Adds the named parameters of a list, and those that they depend on, to a document. One that the document has with
/// the same meaning is shared; one with another meaning gets a free name, such as r_2. Returns the names that have
/// changed. Adds nothing, and returns false, if there would be too many; see kMaxParameters.
bool bringParameters(Document &document, const std::vector<Parameter> &from, const std::set<std::string> &wanted,
                     NameChanges &changes);

/// The items of one document that another one has received, with their new ids and indices by the old ones.
struct ReceivedItems {
    std::map<std::uint32_t, std::uint32_t> shapes{}, sources{}, markers{};
};

/// Gives a document the formulas of the items that it has received, and the parameters that these use. `scale` is that
/// of the items. Numbers that do not have the values of their formulas stay plain numbers, and all do if there would be
/// too many parameters.
void bringFormulas(Document &document, const Document &from, const ReceivedItems &items, double scale = 1.0);

} // namespace forefront
