#include "core/drawing/formulas/formulas.hpp"

#include "core/drawing/constraints/fit_roundings.hpp"
#include "core/drawing/constraints/settle.hpp"
#include "core/drawing/formulas/bring_formulas.hpp"
#include "core/drawing/formulas/document_numbers.hpp"
#include "core/drawing/formulas/place_formulas.hpp"
#include "core/drawing/formulas/unchanged_numbers.hpp"
#include "core/drawing/shapes/references.hpp"
#include "core/drawing/shapes/shape_geometry.hpp"
#include "core/engine/spacing/parts/expression/expression.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

namespace forefront {
namespace {

std::string parameterList(const std::vector<Parameter> &parameters) {
    std::string names;
    for (const Parameter &parameter : parameters) {
        names += (names.empty() ? "" : ", ") + parameter.name;
    }
    return names;
}

/// A number with the value of its formula.
struct Follower {
    NumberAddress number;
    double value = 0.0;   ///< of the formula
    bool changed = false; ///< the number had a different value
};

Result<Follower> followerOf(const Document &document, const NumberAddress &number, const std::string &text) {
    if (!readNumber(document, number)) {
        return error("bad-formula", "no number has the address '" + toString(number) + "'",
                     "remove the formula '" + text + "'");
    }
    const Result<double> value = evaluateFormula(document, text);
    if (!value) {
        Diagnostics faults = value.faults();
        faults.front().message = "formula '" + text + "': " + faults.front().message;
        return faults;
    }
    return Follower{number, *value};
}

Result<std::vector<Follower>> followersOf(const Document &document, NumberAddress &failed) {
    std::vector<Follower> followers;
    for (const auto &[address, text] : document.formulas) {
        failed = address;
        Result<Follower> follower = followerOf(document, address, text);
        if (!follower) {
            return follower.faults();
        }
        followers.push_back(*std::move(follower));
    }
    return followers;
}

/// Sets the coordinates of nodes of paths that differ from their formulas, those of a path at once: curves follow their
/// ends, and would be lost if these met on the way. Returns true if there were any.
bool placeNodes(Document &document, std::vector<Follower> &followers) {
    std::map<std::uint32_t, std::vector<Vec2>> places;
    for (Follower &follower : followers) {
        const NumberAddress &number = follower.number;
        const bool across = number.quantity == Quantity::X;
        const bool coordinate = number.hasHandle() && (across || number.quantity == Quantity::Y);
        const std::uint32_t id = number.owner.id;
        const Shape *const shape = coordinate ? findShape(document, id) : nullptr;
        if (shape != nullptr && isPath(*shape) && !hasValue(document, number, follower.value)) {
            Vec2 &node = places.try_emplace(id, shape->nodes).first->second[number.handle];
            (across ? node.x : node.y) = follower.value;
            follower.changed = true;
        }
    }
    for (auto &[id, nodes] : places) {
        std::shared_ptr<const Shape> &place = document.shapes[positionOf(document, id)];
        Shape shape = *place;
        moveNodes(shape, std::move(nodes));
        place = std::make_shared<const Shape>(std::move(shape));
    }
    return !places.empty();
}

/// Sets the numbers that differ from their formulas. Returns true if there were any.
Result<bool> placeOnce(Document &document, std::vector<Follower> &followers, NumberAddress &failed) {
    bool any = placeNodes(document, followers);
    for (Follower &follower : followers) {
        if (!hasValue(document, follower.number, follower.value)) {
            failed = follower.number;
            if (Status status = setNumber(document, follower.number, follower.value); !status.empty()) {
                return status;
            }
            follower.changed = any = true;
        }
    }
    return any;
}

/// Checks each item that has a changed number, once for all of its numbers.
Result<Document> checkedOwners(Document document, const std::vector<Follower> &followers, NumberAddress &failed) {
    std::set<NumberOwner> checked;
    for (const Follower &follower : followers) {
        if (follower.changed && checked.insert(follower.number.owner).second) {
            failed = follower.number;
            Result<Document> next = checkedOwner(document, follower.number);
            if (!next) {
                return next;
            }
            document = *std::move(next);
        }
    }
    return document;
}

/// Sets every number to its formula's value. All are set before any is checked, since a new value may be invalid beside
/// an old one, such as that of the opposite corner of a rectangle.
Result<Document> follow(Document document, NumberAddress &failed) {
    Result<std::vector<Follower>> followers = followersOf(document, failed);
    if (!followers) {
        return followers.faults();
    }
    // A rectangle's corner and its size depend on each other, so one round may not be enough.
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
        const Result<bool> any = placeOnce(document, *followers, failed);
        if (!any) {
            return any.faults();
        }
        if (!*any) {
            return checkedOwners(std::move(document), *followers, failed);
        }
    }
    if (failed.quantity == Quantity::ArcRadius) {
        return error("bad-formula",
                     "the ends of an arc are too far apart for its radius '" + document.formulas.at(failed) + "'",
                     "change a parameter, or remove the formula");
    }
    return error("bad-formula", "formulas of the same shape contradict each other", "remove one of them");
}

} // namespace

namespace {

/// Lets the constraints follow numbers that formulas have set.
Result<Document> settledAfter(const Document &before, const Document &next, NumberAddress &failed) {
    Result<Document> settled = settleTogether(before, next);
    for (const auto &[address, text] : next.formulas) {
        if (!settled || settled->shapes == next.shapes) {
            break;
        }
        const std::optional<double> value = readNumber(next, address);
        if (value && !hasValue(*settled, address, *value)) {
            failed = address;
            const bool joints = next.constraints.empty();
            return error("bad-formula",
                         std::string(joints ? "joints contradict" : "constraints contradict") + " the formula '" +
                             text + "'",
                         joints ? "remove it, or detach the shapes by dragging a node with Alt"
                                : "remove it, or a constraint of " + numberName(next, address));
        }
    }
    return settled ? fitRoundings(before, *std::move(settled)) : settled;
}

} // namespace

Result<double> evaluateFormula(const Document &document, const std::string &text) {
    return evaluateExpression(text, document.spacing.names);
}

Result<Document> applyFormulas(const Document &document, NumberAddress *failed) {
    NumberAddress address;
    Result<Document> next = follow(document, address);
    next = next ? settledAfter(document, *next, address) : next;
    if (!next && failed != nullptr) {
        *failed = address;
    }
    return next;
}

Result<Document> setParameters(const Document &document, std::vector<Parameter> parameters) {
    const std::vector<ParameterState> states = parameterStates(parameters);
    for (std::size_t k = 0; k < states.size(); ++k) {
        if (!states[k].value && !states[k].follows) { // what follows from another fault comes after its cause
            return error("bad-parameter", "parameter '" + parameters[k].name + "': " + states[k].fault,
                         "change its name or its expression");
        }
    }
    Document next = document;
    next.parameters = std::move(parameters);
    next.spacing.names = parameterValues(next.parameters);
    return applyFormulas(next);
}

Result<Document> overrideParameters(const Document &document, const std::map<std::string, std::string> &expressions) {
    std::vector<Parameter> parameters = document.parameters;
    for (const auto &[name, expression] : expressions) {
        const std::size_t index = parameterIndex(parameters, name);
        if (index == parameters.size()) {
            return parameters.empty()
                       ? error("unknown-parameter", "unknown parameter '" + name + "'; the project has no parameters")
                       : error("unknown-parameter",
                               "unknown parameter '" + name + "'; expected " + parameterList(parameters));
        }
        parameters[index].expression = expression;
    }
    return setParameters(document, std::move(parameters));
}

namespace {

/// Names the users of a parameter, in words.
std::vector<std::string> usersOf(const Document &document, const std::string &name) {
    const auto uses = [&name](const std::string &text) { return renameIn(text, {{name, name + '_'}}) != text; };
    std::vector<std::string> users;
    for (const Parameter &parameter : document.parameters) {
        if (parameter.name != name && uses(parameter.expression)) {
            users.push_back("the parameter " + parameter.name);
        }
    }
    for (const auto &[address, text] : document.formulas) {
        if (uses(text)) {
            users.push_back("the " + numberName(document, address));
        }
    }
    if (document.spacing.expression && uses(*document.spacing.expression)) {
        users.emplace_back("the spacing expression");
    }
    return users;
}

} // namespace

Result<Document> removeParameter(const Document &document, std::size_t index) {
    if (index >= document.parameters.size()) {
        return error("bad-parameter", "parameter not found");
    }
    const std::string &name = document.parameters[index].name;
    const std::vector<std::string> users = usersOf(document, name);
    if (!users.empty()) {
        constexpr std::size_t kListed = 3;
        std::string list;
        for (std::size_t k = 0; k < std::min(users.size(), kListed); ++k) {
            list += (k == 0 ? "" : k + 1 == users.size() ? " and " : ", ") + users[k];
        }
        list += users.size() > kListed ? " and " + std::to_string(users.size() - kListed) + " more" : "";
        return error("parameter-in-use", name + " is used by " + list,
                     users.size() == 1 ? "enter a number there first" : "enter numbers there first");
    }
    std::vector<Parameter> parameters = document.parameters;
    parameters.erase(parameters.begin() + static_cast<std::ptrdiff_t>(index));
    return setParameters(document, std::move(parameters));
}

Result<Document> renameParameter(const Document &document, std::size_t index, const std::string &name) {
    if (index >= document.parameters.size()) {
        return error("bad-parameter", "parameter not found");
    }
    const NameChanges change{{document.parameters[index].name, name}};
    Document next = document;
    next.parameters[index].name = name;
    const ParameterState state = parameterStates(next.parameters)[index];
    if (state.faultyName) {
        return error("bad-parameter", state.fault);
    }
    for (Parameter &parameter : next.parameters) {
        parameter.expression = renameIn(parameter.expression, change);
    }
    for (auto &[address, text] : next.formulas) {
        text = renameIn(text, change);
    }
    if (next.spacing.expression) {
        next.spacing.expression = renameIn(*next.spacing.expression, change);
    }
    return setParameters(next, next.parameters);
}

Document setFormula(Document document, const NumberAddress &address, const std::string &text) {
    if (text.empty() || plainNumber(text)) {
        document.formulas.erase(address);
    } else {
        document.formulas[address] = text;
    }
    return document;
}

namespace {

/// Returns true if a number exists and has the value of a formula.
bool holds(const Document &document, const NumberAddress &address, const std::string &text) {
    const Result<double> value = evaluateFormula(document, text);
    return value && hasValue(document, address, *value);
}

} // namespace

void pruneFormulas(Document &document) {
    std::erase_if(document.formulas,
                  [&](const auto &formula) { return !holds(document, formula.first, formula.second); });
}

void carryFormulas(const Document &before, Document &next) {
    if (next.formulas.empty()) {
        return;
    }
    const UnchangedNumbers unchanged(before, next);
    const bool sameValues = before.spacing.names == next.spacing.names;
    std::map<NumberAddress, std::string> carried;
    for (const auto &[address, text] : next.formulas) {
        const auto old = before.formulas.find(address);
        const bool sameFormula = old != before.formulas.end() && old->second == text;
        // Most formulas of a drag: nothing to evaluate.
        if (sameFormula && sameValues && unchanged.contains(address)) {
            carried.emplace(address, text);
            continue;
        }
        const std::optional<NumberAddress> now =
            sameFormula ? movedAddress(before, next, address) : std::optional(address);
        if (now && holds(next, *now, text)) {
            carried.emplace(*now, text);
        }
    }
    next.formulas = std::move(carried);
}

FormulaRange formulasOf(Document &document, NumberOwner owner) {
    const auto begin = document.formulas.lower_bound({owner, Quantity{}, 0});
    const auto end = std::find_if(begin, document.formulas.end(),
                                  [owner](const auto &formula) { return formula.first.owner != owner; });
    return {begin, end};
}

void copyFormulas(Document &document, NumberOwner from, NumberOwner to) {
    std::map<NumberAddress, std::string> copies;
    for (const auto &[address, text] : formulasOf(document, from)) {
        copies.emplace(NumberAddress{to, address.quantity, address.handle}, text);
    }
    document.formulas.merge(copies);
}

} // namespace forefront
