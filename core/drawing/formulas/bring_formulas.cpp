#include "core/drawing/formulas/bring_formulas.hpp"

#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/formulas.hpp"
#include "core/engine/base/number_text.hpp"
#include "core/engine/spacing/parts/expression/expression_parser.hpp"
#include "core/engine/spacing/scaled_sizes.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

/// Adds the names that an expression uses.
void addNames(const std::string &text, std::set<std::string> &names) {
    for (const std::string_view name : namesIn(text)) {
        names.emplace(name);
    }
}

/// Returns the wanted parameters and those that they depend on, in the order of the list, without the shared ones.
std::vector<Parameter> withDependencies(const std::vector<Parameter> &from, std::set<std::string> wanted,
                                        const std::set<std::string> &shared) {
    for (std::size_t count = 0; count != wanted.size();) {
        count = wanted.size();
        for (const Parameter &parameter : from) {
            if (wanted.contains(parameter.name) && !shared.contains(parameter.name)) {
                addNames(parameter.expression, wanted);
            }
        }
    }
    std::vector<Parameter> list;
    std::copy_if(from.begin(), from.end(), std::back_inserter(list), [&](const Parameter &parameter) {
        return wanted.contains(parameter.name) && !shared.contains(parameter.name);
    });
    return list;
}

/// Returns the names that have the same value in both.
std::set<std::string> sharedNames(const NamedValues &first, const NamedValues &second) {
    std::set<std::string> shared;
    for (const auto &[name, value] : first) {
        if (const auto other = second.find(name); other != second.end() && other->second == value) {
            shared.insert(name);
        }
    }
    return shared;
}

/// Returns the new address of a number that came with an item; none if its item did not come.
std::optional<NumberAddress> newAddress(const NumberAddress &old, const ReceivedItems &items) {
    const auto &[kind, id] = old.owner;
    const auto *const places = kind == NumberOwner::Kind::Shape        ? &items.shapes
                               : kind == NumberOwner::Kind::Source     ? &items.sources
                               : kind == NumberOwner::Kind::Region     ? &items.markers
                               : kind == NumberOwner::Kind::Constraint ? &items.constraints
                                                                       : nullptr;
    if (places == nullptr || !places->contains(id)) {
        return std::nullopt;
    }
    return NumberAddress{{kind, places->at(id)}, old.quantity, old.handle};
}

} // namespace

std::string timesLength(const std::string &formula, double scale, int power) {
    return scale == 1.0 || power == 0 ? formula : scaledExpression(formula, power == 2 ? scale * scale : scale);
}

std::string renameIn(const std::string &text, const NameChanges &names) {
    std::string result;
    std::size_t copied = 0;
    for (const std::string_view name : namesIn(text)) {
        if (const auto change = names.find(name); change != names.end()) {
            const auto at = static_cast<std::size_t>(name.data() - text.data());
            result += text.substr(copied, at - copied) + change->second;
            copied = at + name.size();
        }
    }
    return result + text.substr(copied);
}

std::vector<Parameter> constantParameters(const NamedValues &values) {
    std::vector<Parameter> list;
    for (const auto &[name, value] : values) {
        list.push_back({name, exactText(value)});
    }
    return list;
}

bool bringParameters(Document &document, const std::vector<Parameter> &from, const std::set<std::string> &wanted,
                     NameChanges &changes) {
    const std::set<std::string> shared = sharedNames(parameterValues(document.parameters), parameterValues(from));
    const std::vector<Parameter> list = withDependencies(from, wanted, shared);
    const std::set<std::string> known = namesOf(document.parameters);
    std::set<std::string> taken = namesOf(list);
    taken.insert(known.begin(), known.end());
    changes.clear();
    for (const Parameter &parameter : list) {
        if (known.contains(parameter.name)) {
            changes[parameter.name] = freeParameterName(parameter.name + '_', 2, taken);
            taken.insert(changes[parameter.name]);
        }
    }
    if (document.parameters.size() + list.size() > kMaxParameters) {
        return false;
    }
    for (const Parameter &parameter : list) {
        const auto change = changes.find(parameter.name);
        document.parameters.push_back(
            {change != changes.end() ? change->second : parameter.name, renameIn(parameter.expression, changes)});
    }
    document.spacing.names = parameterValues(document.parameters);
    return true;
}

std::size_t bringFormulas(Document &document, const Document &from, const ReceivedItems &items, double scale) {
    std::map<NumberAddress, std::string> brought;
    std::set<std::string> wanted;
    for (const auto &[old, text] : from.formulas) {
        const std::optional<NumberAddress> address = newAddress(old, items);
        const std::string scaled = timesLength(text, scale, lengthPower(from, old));
        const Result<double> value = evaluateFormula(from, scaled);
        if (address && value && hasValue(document, *address, *value)) {
            brought[*address] = scaled;
            addNames(text, wanted);
        }
    }
    NameChanges changes;
    if (brought.empty()) {
        return 0;
    }
    if (!bringParameters(document, from.parameters, wanted, changes)) {
        return brought.size();
    }
    for (const auto &[address, text] : brought) {
        document.formulas[address] = renameIn(text, changes);
    }
    return 0;
}

} // namespace forefront
