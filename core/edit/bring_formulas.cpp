#include "core/edit/bring_formulas.hpp"

#include "core/base/number_text.hpp"
#include "core/edit/formulas.hpp"
#include "core/edit/number_address.hpp"
#include "core/spacing/parts/expression/expression_parser.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace forefront {
namespace {

const Parameter *findParameter(const std::vector<Parameter> &parameters, std::string_view name) {
    const auto found = std::find_if(parameters.begin(), parameters.end(),
                                    [&](const Parameter &parameter) { return parameter.name == name; });
    return found == parameters.end() ? nullptr : &*found;
}

/// Adds the names that an expression uses.
void addNames(const std::string &text, std::set<std::string> &names) {
    for (const std::string_view name : namesIn(text)) {
        names.emplace(name);
    }
}

/// Returns the wanted parameters and those that they depend on, in the order of the list.
std::vector<Parameter> withDependencies(const std::vector<Parameter> &from, std::set<std::string> wanted) {
    for (std::size_t count = 0; count != wanted.size();) {
        count = wanted.size();
        for (const Parameter &parameter : from) {
            if (wanted.contains(parameter.name)) {
                addNames(parameter.expression, wanted);
            }
        }
    }
    std::vector<Parameter> list;
    std::copy_if(from.begin(), from.end(), std::back_inserter(list),
                 [&](const Parameter &parameter) { return wanted.contains(parameter.name); });
    return list;
}

/// Returns the names of those parameters that mean something else in a document: another expression, or one that
/// depends on such a parameter.
std::set<std::string> conflicts(const Document &document, const std::vector<Parameter> &list) {
    std::set<std::string> names;
    std::size_t count = 0;
    do {
        count = names.size();
        for (const Parameter &parameter : list) {
            const Parameter *const known = findParameter(document.parameters, parameter.name);
            const std::vector<std::string_view> uses = namesIn(parameter.expression);
            const bool differs = known != nullptr && (known->expression != parameter.expression ||
                                                      std::any_of(uses.begin(), uses.end(), [&](std::string_view name) {
                                                          return names.contains(std::string(name));
                                                      }));
            if (differs) {
                names.insert(parameter.name);
            }
        }
    } while (names.size() != count);
    return names;
}

/// Returns a name like `name` that is not taken.
std::string freeName(const std::string &name, const std::set<std::string> &taken) {
    for (int number = 2;; ++number) {
        const std::string suffix = '_' + std::to_string(number);
        std::string next = name.substr(0, kMaxParameterName - suffix.size()) + suffix;
        if (!taken.contains(next)) {
            return next;
        }
    }
}

/// Returns the new address of a number that came with an item; none if its item did not come.
std::optional<NumberAddress> newAddress(const std::string &text, const ReceivedItems &items) {
    using Owner = NumberAddress::Owner;
    std::optional<NumberAddress> address = parseAddress(text);
    const auto *const places = !address                          ? nullptr
                               : address->owner == Owner::Shape  ? &items.shapes
                               : address->owner == Owner::Source ? &items.sources
                               : address->owner == Owner::Region ? &items.markers
                                                                 : nullptr;
    const auto place = places != nullptr ? places->find(address->id) : items.shapes.end();
    if (places == nullptr || place == places->end()) {
        return std::nullopt;
    }
    address->id = place->second;
    return address;
}

std::string timesFactor(const std::string &text, double factor) {
    return factor == 1.0 ? text : exactText(factor) + "*(" + text + ')';
}

} // namespace

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
    const std::vector<Parameter> list = withDependencies(from, wanted);
    std::set<std::string> taken;
    for (const Parameter &parameter : document.parameters) {
        taken.insert(parameter.name);
    }
    for (const Parameter &parameter : list) {
        taken.insert(parameter.name);
    }
    changes.clear();
    for (const std::string &name : conflicts(document, list)) {
        changes[name] = freeName(name, taken);
        taken.insert(changes[name]);
    }
    if (taken.size() > kMaxParameters) {
        return false;
    }
    for (const Parameter &parameter : list) {
        const auto change = changes.find(parameter.name);
        if (change != changes.end()) {
            document.parameters.push_back({change->second, renameIn(parameter.expression, changes)});
        } else if (findParameter(document.parameters, parameter.name) == nullptr) {
            document.parameters.push_back({parameter.name, renameIn(parameter.expression, changes)});
        }
    }
    document.spacing.names = parameterValues(document.parameters);
    return true;
}

void bringFormulas(Document &document, const Document &from, const ReceivedItems &items, double scale) {
    std::map<std::string, std::string> brought;
    std::set<std::string> wanted;
    for (const auto &[old, text] : from.formulas) {
        const std::optional<NumberAddress> address = newAddress(old, items);
        const double factor = address && address->quantity == "area" ? scale * scale : scale;
        const std::string scaled = timesFactor(text, factor);
        const Result<double> value = evaluateFormula(from, scaled);
        if (address && value && hasValue(document, *address, *value)) {
            brought[toString(*address)] = scaled;
            addNames(text, wanted);
        }
    }
    NameChanges changes;
    if (!brought.empty() && bringParameters(document, from.parameters, wanted, changes)) {
        for (const auto &[address, text] : brought) {
            document.formulas[address] = renameIn(text, changes);
        }
    }
}

} // namespace forefront
